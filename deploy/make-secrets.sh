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

if [ ! -e ca.pem ]; then
  openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:P-256 -nodes -days 3650 \
    -subj '/CN=Authority of NATS for Ubi-Interact' \
    -addext 'keyUsage=critical,keyCertSign,cRLSign' -keyout ca-key.pem -out ca.pem
fi

if [ ! -e nats.pem ]; then
  names='DNS:localhost,IP:127.0.0.1'
  for name in "$@"; do
    case $name in
      *[!0-9.]*) names="$names,DNS:$name" ;;
      *) names="$names,IP:$name" ;;
    esac
  done
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
