#!/usr/bin/env bash
# The README's two commands on a system that has nothing yet, as a container for CI usually is: root without the rights to make
# namespaces, a checkout that all can read, so no bubblewrap. Needs root. What was committed is tried. Usage: debian.sh
# BUILD SUITE [COMMANDS, a file: instead]. TARGETS=check-class: these alone.
set -eu
suite=$2
mkdir -p "$1/debian"
cd "$1/debian"
[ "$(id -u)" = 0 ] && command -v debootstrap >/dev/null || { echo "this needs root and debootstrap: sudo make setup check-debian"; exit 1; }
umask 022
if ! [ -f "$suite.tar" ]; then
    from=http://deb.debian.org/debian components=main
    # Ubuntu's suites, of which Debian's debootstrap may be older than this one; they are all made in one way.
    [ "$suite" != noble ] || { from="http://archive.ubuntu.com/ubuntu /usr/share/debootstrap/scripts/gutsy" components=main,universe; }
    # shellcheck disable=SC2086  # falls apart into words
    debootstrap --variant=minbase --components="$components" "$suite" "$suite.new" $from >"$suite.log" || { tail -5 "$suite.log"; exit 1; }
    tar -C "$suite.new" -cf "$suite.tar.new" . && mv "$suite.tar.new" "$suite.tar" && rm -rf "$suite.new"
fi
rm -rf "$suite" && mkdir "$suite" && tar -C "$suite" -xf "$suite.tar"
git clone -q --no-hardlinks "$(git rev-parse --show-toplevel)" "$suite/photonlab"
cp /etc/resolv.conf "$suite/etc/"

cat >"$suite/commands" <<END
set -eux
umask 022
apt-get -qq update
apt-get -qq install -y --no-install-recommends ca-certificates git make procps >/dev/null
cd /photonlab
for target in ${TARGETS:-demo check}; do make setup \$target; done
END
[ $# = 2 ] || cp "$3" "$suite/commands"
# The rights that Docker leaves to root; in a changed root no namespace for users can be made either.
rights=-all
for right in chown dac_override fowner fsetid kill setgid setuid setpcap net_bind_service net_raw sys_chroot mknod audit_write setfcap; do
    rights+=,+$right
done
there=$PWD/$suite
export there rights
exec unshare --mount --pid --ipc --uts --fork sh -eu -c '
    mount -t proc proc "$there/proc"
    mount -t sysfs -o ro sys "$there/sys"
    mount -t tmpfs none "$there/dev"
    mkdir "$there/dev/shm" "$there/dev/pts"
    mount -t tmpfs none "$there/dev/shm"
    mount -t devpts -o newinstance,ptmxmode=0666 none "$there/dev/pts"
    ln -s pts/ptmx "$there/dev/ptmx"
    ln -s /proc/self/fd "$there/dev/fd"
    for device in null zero full random urandom tty; do cp -a "/dev/$device" "$there/dev/"; done
    exec env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root setpriv --bounding-set "$rights" --inh-caps=-all chroot "$there" sh /commands'
