#!/bin/sh
# Creates what NATS and the masters need to trust each other, in deploy/secrets: an authority, a certificate of the
# NATS servers, and the login of the masters. What exists already is kept: remove nats.pem to renew the certificate.
#
#   sh deploy/make-secrets.sh [<name or address of a machine of NATS>...]
set -eu
umask 077
cd "$(dirname "$0")"
mkdir -p secrets
cd secrets

# Usage: check_name <host|ip> <name>
check_name() {
  if openssl x509 -in nats.pem -noout "-check$1" "$2" | grep -q 'does match'; then return; fi
  echo "deploy/secrets/nats.pem is not for $2. Remove it, then run this again with all names and addresses." >&2
  exit 1
}

if [ ! -e ca.pem ]; then
  openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -days 3650 \
    -subj '/CN=Authority of NATS for Ubi-Interact' \
    -addext 'keyUsage=critical,keyCertSign,cRLSign' -keyout ca-key.pem -out ca.pem
fi

names='DNS:localhost,IP:127.0.0.1'
for name in "$@"; do
  case $name in
    *:*) kind=ip names="$names,IP:$name" ;;
    *[!0-9.]*) kind=host names="$names,DNS:$name" ;;
    *) kind=ip names="$names,IP:$name" ;;
  esac
  if [ -e nats.pem ]; then check_name "$kind" "$name"; fi
done

if [ ! -e nats.pem ]; then
  {
    echo 'basicConstraints=critical,CA:FALSE'
    echo 'keyUsage=critical,digitalSignature'
    # Servers of NATS are clients of each other.
    echo 'extendedKeyUsage=serverAuth,clientAuth'
    echo "subjectAltName=$names"
  } >nats.ext
  openssl req -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -subj '/CN=nats' \
    -keyout nats-key.pem -out nats.csr
  openssl x509 -req -in nats.csr -CA ca.pem -CAkey ca-key.pem -CAcreateserial -days 825 \
    -extfile nats.ext -out nats.pem
  rm nats.csr nats.ext
fi

if [ ! -e nats-login ]; then
  password=$(openssl rand -hex 32)
  echo "masters:$password" >nats-login
  cat >accounts.conf <<CONF
accounts {
  MASTERS {
    jetstream: enabled
    users: [{ user: masters, password: "$password" }]
  }
}
CONF
fi
