import 'reflect-metadata';

import { randomBytes, webcrypto } from 'node:crypto';
import { BlockList, isIP } from 'node:net';

import { AsnConvert } from '@peculiar/asn1-schema';
import {
  GeneralName,
  GeneralSubtree,
  GeneralSubtrees,
  id_ce_nameConstraints,
  NameConstraints,
} from '@peculiar/asn1-x509';
import * as x509 from '@peculiar/x509';

import { isIpAddress } from '../addresses/address-kinds.ts';

/*
 * Loaded only when something has to be issued: the libraries are large, and most starts of a master
 * find what they need in files.
 */

/** A certificate with its private key, both as PEM. */
export interface Issued {
  /** For a leaf: its own, then its authority's. */
  readonly certificate: string;
  /** PKCS #8. */
  readonly key: string;
}

const ALGORITHM = { name: 'ECDSA', namedCurve: 'P-256', hash: 'SHA-256' } as const;
const DAY_MS = 24 * 60 * 60 * 1000;
const AUTHORITY_DAYS = 10 * 365;
/** iOS takes no longer ones: https://support.apple.com/en-us/102028 */
const LEAF_DAYS = 397;
/** Clocks of phones differ. */
const EARLIER_DAYS = 1;

/** Names that cannot be registered in the public name system. */
const LOCAL_NAMES = ['localhost', 'local', 'lan', 'internal', 'home.arpa'];
/** Loopback, RFC 1918, RFC 6598 (carrier and overlay networks), RFC 3927, RFC 4193, RFC 4291. */
const LOCAL_NETWORKS = [
  '127.0.0.0/8',
  '10.0.0.0/8',
  '172.16.0.0/12',
  '192.168.0.0/16',
  '100.64.0.0/10',
  '169.254.0.0/16',
  '::1/128',
  'fc00::/7',
  'fe80::/10',
];

x509.cryptoProvider.set(webcrypto as Crypto);

/**
 * An authority that can vouch for local names and addresses only (RFC 5280, 4.2.1.10), and for the
 * names and addresses this machine has now: a public address may be all a machine has.
 *
 * @param names hostnames and addresses of this machine
 */
export async function issueAuthority(
  commonName: string,
  names: readonly string[],
  nowMs: number,
): Promise<Issued> {
  const keys = await makeKeys();
  const certificate = await x509.X509CertificateGenerator.createSelfSigned({
    ...validity(nowMs, AUTHORITY_DAYS),
    serialNumber: makeSerialNumber(),
    name: [{ CN: [commonName] }, { O: ['Ubi-Interact'] }],
    keys,
    signingAlgorithm: ALGORITHM,
    extensions: [
      new x509.BasicConstraintsExtension(true, 0, true),
      new x509.KeyUsagesExtension(x509.KeyUsageFlags.keyCertSign, true),
      nameConstraints(names),
      await x509.SubjectKeyIdentifierExtension.create(keys.publicKey),
    ],
  });
  return { certificate: certificate.toString('pem'), key: await pemOf(keys) };
}

/**
 * A certificate for a server of these names. Those its authority cannot vouch for are left out: one
 * of them would make all of it worthless.
 *
 * @param names hostnames and addresses
 * @throws Error when the authority's certificate or key cannot be read
 */
export async function issueLeaf(
  authority: Issued,
  names: readonly string[],
  nowMs: number,
): Promise<Issued> {
  const issuer = new x509.X509Certificate(authority.certificate);
  const signingKey = await readKey(authority.key);
  const keys = await makeKeys();
  const covered = names.filter((name) => isPermitted(issuer, name));
  const certificate = await x509.X509CertificateGenerator.create({
    ...validity(nowMs, LEAF_DAYS),
    serialNumber: makeSerialNumber(),
    subject: [{ CN: [covered[0] ?? 'localhost'] }, { O: ['Ubi-Interact'] }],
    issuer: issuer.subject,
    publicKey: keys.publicKey,
    signingKey,
    signingAlgorithm: ALGORITHM,
    extensions: [
      new x509.BasicConstraintsExtension(false, undefined, true),
      new x509.KeyUsagesExtension(x509.KeyUsageFlags.digitalSignature, true),
      new x509.ExtendedKeyUsageExtension([x509.ExtendedKeyUsage.serverAuth]),
      new x509.SubjectAlternativeNameExtension(
        covered.map((value) => ({
          type: isIpAddress(value) ? ('ip' as const) : ('dns' as const),
          value,
        })),
      ),
      await x509.AuthorityKeyIdentifierExtension.create(issuer.publicKey),
      await x509.SubjectKeyIdentifierExtension.create(keys.publicKey),
    ],
  });
  const chain = `${certificate.toString('pem')}\n${authority.certificate.trim()}\n`;
  return { certificate: chain, key: await pemOf(keys) };
}

/** Whether an authority may vouch for a name or address; one without constraints may for all. */
function isPermitted(authority: x509.X509Certificate, name: string): boolean {
  const extension = authority.getExtension(id_ce_nameConstraints);
  if (extension === null) return true;
  const { permittedSubtrees } = AsnConvert.parse(extension.value, NameConstraints);
  const bases = [...(permittedSubtrees ?? [])].map(({ base }) => base);
  if (!isIpAddress(name)) {
    return bases.some(({ dNSName }) => name === dNSName || name.endsWith(`.${dNSName}`));
  }
  const networks = new BlockList();
  for (const { iPAddress } of bases) if (iPAddress !== undefined) addNetwork(networks, iPAddress);
  return networks.check(name, isIP(name) === 6 ? 'ipv6' : 'ipv4');
}

function addNetwork(networks: BlockList, text: string): void {
  const [address = '', bits] = text.split('/');
  const family = isIP(address) === 6 ? 'ipv6' : 'ipv4';
  networks.addSubnet(address, Number(bits), family);
}

function nameConstraints(names: readonly string[]): x509.Extension {
  const hosts = names.filter((name) => !isIpAddress(name));
  const own = names
    .filter(isIpAddress)
    .map((address) => `${address}/${isIP(address) === 6 ? 128 : 32}`);
  const permitted = [...new Set([...LOCAL_NAMES, ...hosts]).values()].map(
    (dNSName) => new GeneralName({ dNSName }),
  );
  const networks = [...new Set([...LOCAL_NETWORKS, ...own])].map(
    (iPAddress) => new GeneralName({ iPAddress }),
  );
  const value = AsnConvert.serialize(
    new NameConstraints({
      permittedSubtrees: new GeneralSubtrees(
        [...permitted, ...networks].map((base) => new GeneralSubtree({ base })),
      ),
    }),
  );
  return new x509.Extension(id_ce_nameConstraints, true, value);
}

function validity(nowMs: number, days: number): { notBefore: Date; notAfter: Date } {
  return {
    notBefore: new Date(nowMs - EARLIER_DAYS * DAY_MS),
    notAfter: new Date(nowMs + (days - EARLIER_DAYS) * DAY_MS),
  };
}

/** Positive, and with more than the 64 random bits that are asked for (RFC 5280, 4.1.2.2). */
function makeSerialNumber(): string {
  return `01${randomBytes(15).toString('hex')}`;
}

async function makeKeys(): Promise<CryptoKeyPair> {
  return (await webcrypto.subtle.generateKey(ALGORITHM, true, ['sign', 'verify'])) as CryptoKeyPair;
}

async function pemOf({ privateKey }: CryptoKeyPair): Promise<string> {
  const bytes = await webcrypto.subtle.exportKey('pkcs8', privateKey as webcrypto.CryptoKey);
  return x509.PemConverter.encode(bytes, 'PRIVATE KEY');
}

function readKey(pem: string): Promise<CryptoKey> {
  const bytes = x509.PemConverter.decodeFirst(pem);
  return webcrypto.subtle.importKey('pkcs8', bytes, ALGORITHM, false, [
    'sign',
  ]) as Promise<CryptoKey>;
}
