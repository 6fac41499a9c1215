import { errors } from '@nats-io/transport-node';
import { JetStreamApiCodes, JetStreamApiError } from '@nats-io/jetstream';
import { ConfigError } from '@ubii/program';

/** Why a master cannot join its cluster. */
export interface StartFailure {
  readonly error: ConfigError;
  /** Waiting does not help. */
  readonly isFinal: boolean;
}

/** What to do about a connection that could not be opened. The text has no secrets. */
export function explainStart(cause: unknown, servers: readonly string[]): StartFailure {
  const where = servers.join(', ');
  if (cause instanceof errors.AuthorizationError) {
    const text = `NATS at ${where} refuses this master. Correct the user, password or token in --cluster, or give --cluster-credentials.`;
    return { error: new ConfigError(text), isFinal: true };
  }
  const certificate = explainCertificate(cause, where);
  if (certificate !== undefined) return { error: new ConfigError(certificate), isFinal: true };
  const text = `No NATS server of the cluster can be reached at ${where} (${reasonOf(cause)}). Start NATS, correct --cluster, or start this master without it.`;
  return { error: new ConfigError(text), isFinal: false };
}

function explainCertificate(cause: unknown, where: string): string | undefined {
  const code = cause instanceof Error && 'code' in cause ? String(cause.code) : '';
  if (code === 'ERR_TLS_CERT_ALTNAME_INVALID') {
    return `The certificate of NATS at ${where} has no such address (${reasonOf(cause)}). Write an address in --cluster that the certificate has, or create one for this address.`;
  }
  if (!/CERT|UNABLE_TO_VERIFY/.test(code)) return undefined;
  return `This master does not trust the certificate of NATS at ${where} (${reasonOf(cause)}). Name the authority that issued it with --cluster-ca, or renew the certificate if it has expired.`;
}

/** What to do about stores that could not be opened. */
export function explainStores(cause: unknown): ConfigError {
  const isMissing =
    /jetstream.*not.*enabled|no responders|503/i.test(reasonOf(cause)) ||
    (cause instanceof JetStreamApiError &&
      cause.code === JetStreamApiCodes.JetStreamNotEnabledForAccount);
  return new ConfigError(
    isMissing
      ? 'NATS has no JetStream, in which a cluster keeps its sessions. Start nats-server with -js and -sd <folder>, and enable JetStream for the account of the masters.'
      : `The stores of the cluster cannot be opened in NATS: ${reasonOf(cause)}`,
  );
}

/** Whether a compare-and-set found another revision than it expected. */
export function isConflict(cause: unknown): boolean {
  return (
    cause instanceof JetStreamApiError &&
    (cause.code === JetStreamApiCodes.StreamWrongLastSequence ||
      cause.code === JetStreamApiCodes.StreamWrongLastSequenceUnknown)
  );
}

/** The first sentence of an error. */
export function reasonOf(cause: unknown): string {
  return cause instanceof Error && cause.message !== '' ? cause.message : String(cause);
}

/** Whether a key, or all of its stream, is not there. */
export function isNotFound(cause: unknown): boolean {
  return cause instanceof JetStreamApiError && cause.code === JetStreamApiCodes.NoMessageFound;
}
