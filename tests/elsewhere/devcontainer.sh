#!/usr/bin/env bash
# The steps of .devcontainer/Dockerfile on a bare Debian; in it, as the user that they make, the task that shows photons to a browser.
# Usage: devcontainer.sh BUILD
set -eu
file=.devcontainer/Dockerfile
suite=$(sed -n 's/^FROM debian:\([a-z]*\)-slim$/\1/p' $file)
port=$(sed -n 's/.*make preview WEB=1 PORT=\([0-9]*\).*/\1/p' .vscode/tasks.json)
commands=$(realpath "$1")/devcontainer.commands
cat >"$commands" <<END_OF_COMMANDS
set -eux
umask 022
mkdir /tmp/photonlab
cd /photonlab
$(sed -n 's/^RUN //p' $file)
apt-get -qq update
apt-get -qq install -y --no-install-recommends curl
chown -R student .
cat >task <<'TASK'
make
make compile_commands.json
make preview WEB=1 PORT=$port >said 2>&1 &
for i in \$(seq 1200); do
    url=\$(grep -o 'http://127.0.0.1:$port/[^ ]*' said | head -1)
    [ -z "\$url" ] || break
    kill -0 \$!
    sleep 1
done
curl -fsS "\$url" | grep '<h1>The lab'
[ "\$(curl -sS -o /dev/null -w '%{http_code}' http://127.0.0.1:$port/)" != 200 ] # without its token
kill \$!
make test STEP=1.1
TASK
su student -c 'bash -eux task' || { cat said; exit 1; }
echo 'as .devcontainer says'
END_OF_COMMANDS
exec bash tests/elsewhere/debian.sh "$1" "$suite" "$commands"
