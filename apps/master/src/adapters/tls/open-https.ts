import type { Config } from '../config/config.ts';
import type { Log } from '../../core/ports/index.ts';
import { isLoopbackHost } from '../addresses/address-kinds.ts';
import { Certificates } from './certificates.ts';
import { OnePort } from './one-port.ts';
import { listOwnNames } from './own-names.ts';

/** Interval of checks for changed addresses of this computer, milliseconds. */
const LOOK_INTERVAL_MS = 10_000;

/** HTTPS on the ports of the master. */
export interface Https {
  readonly onePort: OnePort;
  /** Certificate of the authority that people may install, PEM; none when the certificate is the operator's. */
  readonly authority: string | undefined;
  /** Ends the looking for new addresses. */
  close(): void;
}

/**
 * Opens it where it is of use: browsers trust this machine's own pages without.
 *
 * @param host what the master listens on
 * @throws ConfigError when there is a certificate that cannot be used
 */
export async function openHttps(
  config: Config,
  host: string,
  log: Log,
): Promise<Https | undefined> {
  const { tlsCertificate, tlsKey, tlsAuthority, dataDir, name } = config;
  const own =
    tlsCertificate === undefined || tlsKey === undefined
      ? undefined
      : { certificate: tlsCertificate, key: tlsKey };
  const isWanted = config.https === 'on' && (own !== undefined || !isLoopbackHost(host));
  if (!isWanted) return undefined;
  const certificates = await Certificates.open({
    dataDir,
    own,
    log,
    sharedAuthority: tlsAuthority,
    names: listOwnNames,
    masterName: name,
    nowMs: Date.now,
  });
  const onePort = new OnePort(certificates.served);
  const look = async (): Promise<void> => {
    try {
      if (await certificates.renewIfNeeded()) onePort.show(certificates.served);
    } catch (error) {
      log.error('the certificate could not be renewed', { reason: String(error) });
    }
  };
  const timer = setInterval(() => void look(), LOOK_INTERVAL_MS).unref();
  return { onePort, authority: certificates.authority, close: () => clearInterval(timer) };
}
