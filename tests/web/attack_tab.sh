#!/usr/bin/env bash
# Attacks on the server of `make preview WEB=1`: refused, and told in the terminal. Usage: attack_tab.sh SERVE
set -u
serve=$1
here=$(cd "$(dirname "$0")" && pwd)
. "$here/../common.sh"
trap 'kill "$server" 2>/dev/null; rm -rf "$work"' EXIT
command -v curl >/dev/null || bad "curl is missing: make setup"

mkdir -p "$work/page" "$work/steps" "$work/objects"
echo "the page" >"$work/page/tab.html"
echo "a script" >"$work/page/tab.js"
echo "a module" >"$work/page/photonlab.wasm"
echo "a secret" >"$work/secret"
ln -s ../secret "$work/page/link"
log=$work/log
# start [SETTING…]: another server, with these in its environment; sets $server, $url, $port, $token.
start() {
    env "$@" "$serve" "$work/page" --watch "$work/steps" --code "$work/objects" --build false --link 'echo linked >"$1"' >"$log" 2>&1 &
    server=$!
    for _ in $(seq 100); do
        url=$(sed -n 's/^Your photons: //p' "$log")
        [ -z "$url" ] || break
        sleep 0.02
    done
    port=${url#http://127.0.0.1:} && port=${port%%/*}
    token=${url%/} && token=${token##*/}
}

# status ARGUMENT…: what curl is answered; 000: nothing.
status() {
    curl -s -o "$work/answer" -m 5 --path-as-is -w '%{http_code}' "$@"
}
# answers TEXT PATTERN ARGUMENT…
answers() {
    local text=$1 pattern=$2 found
    shift 2
    found=$(status "$@")
    [[ $found =~ ^($pattern)$ ]] && good "$text: $found" || bad "$text: expected $pattern, found $found: $(head -c 200 "$work/answer")"
    ! grep -q secret "$work/answer" || bad "$text: the secret was given away"
}
told() {
    grep -qF "refused: $1" "$log" && good "the terminal tells: $(grep -F "refused: $1" "$log" | head -1)" || bad "the terminal does not tell: $1"
}

start
first=$token
[[ $token =~ ^[0-9a-f]{32}$ ]] && good "a token of 128 bits" || bad "a token of 128 bits: $token"
answers "the page itself" 200 "$url"
answers "… by a forwarded port" 200 -H 'Host: localhost:9' "$url"
answers "… and what it tells there" 200 -H 'Host: localhost:9' -H 'Origin: http://localhost:9' -H 'Sec-Fetch-Site: same-origin' -d '' "$url"next
answers "… where another page of that port's machine stands" 403 -H 'Host: localhost:9' -H 'Origin: http://127.0.0.1:9' -d '' "$url"next
curl -s -D - -o /dev/null "$url" | grep -qi "^content-security-policy: default-src 'none'" && good "its scripts come from the server alone" || bad "no policy for scripts"

# Other names for this machine, other pages, other sites.
for host in evil.example 127.0.0.1.evil.example localhost.evil.example localhost:80@evil.example '127.0.0.1:80:80x' ''; do
    answers "Host: $host" '40[03]' -H "Host: $host" "$url"
done
answers "no Host at all" '40[03]' -0 -H 'Host:' "$url"
told "it does not name this machine"
for origin in http://evil.example null "https://127.0.0.1:$port" "http://127.0.0.1:$((port + 1))"; do
    answers "Origin: $origin" 403 -H "Origin: $origin" "$url"state
    answers "Origin: $origin tells of a fault" 403 -H "Origin: $origin" -d '1 loop photons 1' "$url"fault
done
told "it comes from another page"
answers "Sec-Fetch-Site: cross-site" 403 -H 'Sec-Fetch-Site: cross-site' "$url"
told "it comes from another site"

# Tokens, names, methods.
root=http://127.0.0.1:$port
for path in / /state "/$(echo "$token" | tr 0-9a-f 1-9a-f0)/" "/${token%?}/" "/${token}0/" "/${token^^}x/" "//$token/" "/x/../$token/"; do
    answers "no token: ${path:0:12}" 403 "$root$path"
done
told "it has not the address that was printed"
for path in ../secret ..%2fsecret %2e%2e/secret %2e%2e%2fsecret ..%5csecret ../../../../etc/passwd /etc/passwd %2fetc%2fpasswd link tab.html ./ page/ 'state/..' 'STATE'; do
    answers "a path that leaves: $path" 404 "$url$path"
done
told "there is nothing of this name"
answers "a path that leaves: .%00/" '404|400' "$url.%00/" # newer libmicrohttpds refuse it before we do
for method in PUT DELETE OPTIONS TRACE PATCH; do
    answers "$method" '403|405|501' -X "$method" "$url"
done
answers "a page that is told something" 404 -d x "$url"

# Too much, and nonsense.
head -c 200000 /dev/zero | tr '\0' a >"$work/long"
answers "an address of 100 kB" '000|4..' "$url$(head -c 100000 "$work/long")"
# By fours: newer curls send no longer line.
answers "headers of 200 kB" '000|4..' -H @<(for i in 1 2 3 4; do echo "X-Long-$i: $(head -c 50000 "$work/long")"; done) "$url"
answers "a header of 2000 lines" '000|4..' -H @<(seq -f 'X-%.0f: y' 2000) "$url"
answers "a fault of 200 kB" '000|4..' -H 'Expect:' --data-binary @"$work/long" "$url"fault
told "it tells too much"
for body in '' 'x' '1' '1 loop' '1 loop photons' '99999999999 loop photons 1' '1 nonsense photons 1' '1 loop nonsense 1' '1 loop photons x'; do
    answers "a fault: '$body'" '200|400' -d "$body" "$url"fault
done
answers "the state after nonsense" 200 "${url}state?after=%00%ff%0a-1"
printf 'nonsense\r\n\r\n' >"/dev/tcp/127.0.0.1/$port"
printf '\0\1\2\3\377' >"/dev/tcp/127.0.0.1/$port"

# A thousand connections that say nothing, and one that says a letter now and then.
ulimit -n 4096 2>/dev/null
opened=0
for _ in $(seq 1000); do
    { exec {one}<>"/dev/tcp/127.0.0.1/$port"; } 2>/dev/null && opened=$((opened + 1))
done
{ for letter in G E T ' ' / x x x x x x x x x x x x x x x x x x x x; do printf %s "$letter" || break; sleep 0.1; done >"/dev/tcp/127.0.0.1/$port"; } 2>/dev/null &
for _ in $(seq 20); do
    [ "$(status "$url")" != 200 ] || break
    sleep 0.1
done
answers "the page, beside $opened connections that say nothing" 200 "$url"
told "connections that ask nothing, while there are many"
open=$(find "/proc/$server/fd" -lname 'socket:*' 2>/dev/null | wc -l)
check "$open < 300" "of them $open are open"

addresses=$(awk -v port="$(printf %04X "$port")" '$2 ~ ":" port "$" && $4 == "0A" {print $2}' /proc/net/tcp /proc/net/tcp6)
[ "$addresses" = "0100007F:$(printf %04X "$port")" ] && good "it listens at 127.0.0.1 and nowhere else" || bad "it listens at: $addresses"
lines=$(grep -c '^refused' "$log")
check "$lines <= 100" "the terminal is not flooded: $lines refusals are told"
! grep -qP '[\x00-\x08\x0b-\x1f\x7f]' "$log" && good "… without control characters" || bad "control characters in the terminal"
kill "$server" && wait "$server"
start
[ "$token" != "$first" ] && good "another token each time" || bad "the same token again"
kill "$server" && wait "$server"

# GitHub Codespaces forwards the port as another host, and puts localhost into some headers on the way.
start CODESPACE_NAME=fluffy-lamp GITHUB_CODESPACES_PORT_FORWARDING_DOMAIN=app.github.dev
codespace=fluffy-lamp-$port.app.github.dev
grep -qF "https://$codespace/$token/" "$log" && good "in Codespaces: the address there is told" || bad "no address in Codespaces: $(cat "$log")"
for host in "$codespace" "localhost:$port"; do
    answers "in Codespaces, Host: $host" 200 -H "Host: $host" "$url"
    for origin in "https://$codespace" "http://localhost:$port" "https://localhost:$port"; do
        answers "… with Origin: $origin" 200 -H "Host: $host" -H "Origin: $origin" -d '' "$url"next
    done
    for origin in "https://evil-lamp-$port.app.github.dev" "https://$codespace.evil.example" "https://localhost:$((port + 1))" "ftp://$codespace" null; do
        answers "… with Origin: $origin" 403 -H "Host: $host" -H "Origin: $origin" -d '' "$url"next
    done
done
for host in "evil-lamp-$port.app.github.dev" "fluffy-lamp-$((port + 1)).app.github.dev" "$codespace.evil.example" app.github.dev evil.example; do
    answers "in Codespaces, Host: $host" 403 -H "Host: $host" "$url"
done
other=(-H "Host: $codespace" -H 'Sec-Fetch-Site: cross-site')
answers "the page, opened from GitHub's" 200 "${other[@]}" -H 'Sec-Fetch-Dest: document' "$url"
answers "… without its token" 403 "${other[@]}" -H 'Sec-Fetch-Dest: document' "http://127.0.0.1:$port/${token//[0-9a-f]/0}/"
answers "… its state" 403 "${other[@]}" -H 'Sec-Fetch-Dest: document' "$url"state
answers "… as a script of another site" 403 "${other[@]}" -H 'Sec-Fetch-Dest: script' "$url"
answers "… in a frame of another site" 403 "${other[@]}" -H 'Sec-Fetch-Dest: iframe' "$url"
kill "$server" && wait "$server"
start CODESPACE_NAME=$'evil.example\n' GITHUB_CODESPACES_PORT_FORWARDING_DOMAIN='x@y/z'
! grep -q Codespaces "$log" && good "names that are none are nobody's" || bad "$(cat "$log")"
finish
