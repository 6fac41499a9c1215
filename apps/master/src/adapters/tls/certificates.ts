import { readFileSync } from 'node:fs';
import { X509Certificate } from 'node:crypto';
import { join } from 'node:path';
import { createSecureContext } from 'node:tls';
import { ConfigError, SECRET_MODE, writeAtomicallySync } from '@ubii/program';
import type { Issued } from './issue-certificates.ts';
import type { Log } from '../../core/ports/index.ts';
import { isIpAddress } from '../addresses/address-kinds.ts';
import { createSharedAuthority, readSharedAuthority } from './shared-authority.ts';

/** Files of a certificate and its key. */
interface CertificateFiles {
  readonly certificate: string;
  readonly key: string;
}

/** @returns undefined when one of the two is not there */
function readCertificate({ certificate, key }: CertificateFiles): Issued | undefined {
  try {
    return { certificate: readFileSync(certificate, 'utf8'), key: readFileSync(key, 'utf8') };
  } catch (error) {
    const { code, message } = error as NodeJS.ErrnoException;
    if (code === 'ENOENT') return undefined;
    throw new ConfigError(`A certificate cannot be read: ${message}.`);
  }
}

/** Writes both; the key is its owner's alone. */
function writeCertificate(files: CertificateFiles, issued: Issued): void {
  writeAtomicallySync(files.key, issued.key, SECRET_MODE);
  writeAtomicallySync(files.certificate, issued.certificate, 0o644);
}

export interface CertificatesOptions {
  readonly dataDir: string;
  /** Files of a certificate of another issuer; the master then issues none. */
  readonly own: CertificateFiles | undefined;
  /** File of an authority that several masters share, created when missing. Default: one of its own. [CU-94] */
  readonly sharedAuthority?: string | undefined;
  /** Hostnames and addresses this machine has now. */
  readonly names: () => readonly string[];
  /** For people: whose authority it is. */
  readonly masterName: string;
  readonly nowMs: () => number;
  readonly log: Log;
}

/** A leaf is issued again when it ends sooner than this. */
const RENEW_BEFORE_MS = 30 * 24 * 60 * 60 * 1000;

/**
 * The certificates of a master: an authority of its own, made at the first start and kept in the data
 * directory, and a leaf for the names and addresses of this machine. Phones that trust the authority
 * trust every later leaf.
 */
export class Certificates {
  readonly #options: CertificatesOptions;
  readonly #authority: Issued | undefined;
  #served: Issued;
  /** Names requested for the leaf certificate; its authority may not permit all. */
  #names: ReadonlySet<string>;

  /** @throws ConfigError when files are there and cannot be used */
  static async open(options: CertificatesOptions): Promise<Certificates> {
    if (options.own !== undefined) {
      const given = readCertificate(options.own);
      if (given === undefined) {
        throw new ConfigError(
          `No certificate found at ${options.own.certificate} (--tls-certificate), or no key at ${options.own.key} (--tls-key).`,
        );
      }
      checkPair(given, 'Use a certificate and the key it was made for, both as PEM.');
      return new Certificates(options, undefined, given, []);
    }
    const authority = await openAuthority(options);
    const names = options.names();
    const leaf = readCertificate(filesOf(options.dataDir, 'leaf'));
    const isKept =
      leaf !== undefined &&
      lasts(leaf, authority, options.nowMs()) &&
      names.every((name) => isFor(leaf, name));
    const served = isKept ? leaf : await renewLeaf(authority, names, options);
    return new Certificates(options, authority, served, names);
  }

  private constructor(
    options: CertificatesOptions,
    authority: Issued | undefined,
    served: Issued,
    names: readonly string[],
  ) {
    this.#options = options;
    this.#authority = authority;
    this.#served = served;
    this.#names = new Set(names);
  }

  /** Certificate that the servers present. */
  get served(): Issued {
    return this.#served;
  }

  /** Certificate of the authority that people may install, PEM; none when the certificate is the operator's. */
  get authority(): string | undefined {
    return this.#authority?.certificate;
  }

  /**
   * Issues another leaf when names or addresses have come, or when it ends soon.
   *
   * @returns whether there is a new one to be served
   */
  async renewIfNeeded(): Promise<boolean> {
    const authority = this.#authority;
    if (authority === undefined) return false;
    const names = this.#options.names();
    const areKnown = names.every((name) => this.#names.has(name));
    if (areKnown && lasts(this.#served, authority, this.#options.nowMs())) return false;
    this.#served = await renewLeaf(authority, names, this.#options);
    this.#names = new Set(names);
    return true;
  }
}

function filesOf(dataDir: string, name: 'authority' | 'leaf'): CertificateFiles {
  const folder = join(dataDir, 'tls');
  return { certificate: join(folder, `${name}.pem`), key: join(folder, `${name}.key`) };
}

async function openAuthority(options: CertificatesOptions): Promise<Issued> {
  if (options.sharedAuthority !== undefined) return openShared(options.sharedAuthority, options);
  const files = filesOf(options.dataDir, 'authority');
  const kept = readCertificate(files);
  if (kept !== undefined) {
    checkPair(
      kept,
      `Delete both ${files.certificate} and ${files.key}. The master then creates another authority, which devices that trusted this one must install.`,
    );
    return kept;
  }
  const authority = await createAuthority(options);
  writeCertificate(files, authority);
  options.log.info('created a certificate authority for this master', { file: files.certificate });
  return authority;
}

/** The authority of all masters that were given the same file. [CU-94] */
async function openShared(file: string, options: CertificatesOptions): Promise<Issued> {
  const { log } = options;
  const kept = readSharedAuthority(file, log);
  if (kept === undefined) {
    const shared = createSharedAuthority(file, await createAuthority(options), log);
    log.info('created a certificate authority for all masters that are given its file', { file });
    return shared;
  }
  checkPair(
    kept,
    `Use a file that a master created, or delete ${file}: the master then creates another authority, which devices that trusted this one must install.`,
  );
  const { ca, publicKey } = new X509Certificate(kept.certificate);
  if (ca && publicKey.asymmetricKeyDetails?.namedCurve === 'prime256v1') return kept;
  throw new ConfigError(
    `The certificate in ${file} (--tls-authority) must be that of an authority, with a key on the curve P-256. Use a file that a master created, or --tls-certificate for a certificate of another authority.`,
  );
}

async function createAuthority({ masterName, names, nowMs }: CertificatesOptions): Promise<Issued> {
  const { issueAuthority } = await import('./issue-certificates.ts');
  return issueAuthority(`Ubi-Interact ${masterName}`, names(), nowMs());
}

async function renewLeaf(
  authority: Issued,
  names: readonly string[],
  { dataDir, nowMs, log }: CertificatesOptions,
): Promise<Issued> {
  const { issueLeaf } = await import('./issue-certificates.ts');
  const leaf = await issueLeaf(authority, names, nowMs());
  writeCertificate(filesOf(dataDir, 'leaf'), leaf);
  const beyond = names.filter((name) => !isFor(leaf, name));
  if (beyond.length > 0) {
    log.warn(
      `Browsers will not trust HTTPS at ${beyond.join(', ')}: the authority of this master certifies private networks and the addresses it was created with. Use --tls-certificate there.`,
    );
  }
  return leaf;
}

/** Whether a leaf comes from this authority, goes with its key, and does not end soon. */
function lasts(leaf: Issued, authority: Issued, nowMs: number): boolean {
  try {
    createSecureContext({ cert: leaf.certificate, key: leaf.key });
    const certificate = new X509Certificate(leaf.certificate);
    return (
      Date.parse(certificate.validTo) - nowMs > RENEW_BEFORE_MS &&
      certificate.verify(new X509Certificate(authority.certificate).publicKey)
    );
  } catch {
    return false;
  }
}

function isFor(leaf: Issued, name: string): boolean {
  const certificate = new X509Certificate(leaf.certificate);
  return (
    (isIpAddress(name) ? certificate.checkIP(name) : certificate.checkHost(name)) !== undefined
  );
}

/** @throws ConfigError when certificate and key are none, or do not go together */
function checkPair({ certificate, key }: Issued, remedy: string): void {
  try {
    createSecureContext({ cert: certificate, key });
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    throw new ConfigError(`The certificate for HTTPS cannot be used (${reason}). ${remedy}`);
  }
}
