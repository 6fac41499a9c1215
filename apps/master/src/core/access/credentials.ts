import type { AccessSecrets } from '../ports/access-secrets.ts';

/** Lifetime of a credential, milliseconds. [AC-13] */
export const CREDENTIAL_LIFETIME_MS = 7 * 24 * 3_600_000;

/** Content of a credential [AC-13]. */
export interface Credential {
  readonly clientId: string;
  readonly grantId: string;
  /** The client that joined first, with whose credential this one did [AC-23]; its own id when it joined itself. */
  readonly holderId: string;
  /** Epoch milliseconds. */
  readonly expiresMs: number;
}

/** Tells a credential from tokens, which have no dot, and from those of other versions. */
const PREFIX = 'u1.';
/** Ids are UUIDs and the end is a number: what is longer is none of ours. */
const MAX_LENGTH = 400;

/** Writes a credential: what it says, then the proof that it was written here. */
export function writeCredential(secrets: AccessSecrets, credential: Credential): string {
  const { clientId, grantId, holderId, expiresMs } = credential;
  const holder = holderId === clientId ? '' : `.${holderId}`;
  const text = `${PREFIX}${clientId}.${grantId}.${Math.round(expiresMs)}${holder}`;
  return `${text}.${secrets.sign(text)}`;
}

/** True for what looks like a credential, and is to be read as one. */
export function looksLikeCredential(bearer: string): boolean {
  return bearer.startsWith(PREFIX);
}

/** Reads a credential; undefined when this master did not write it. Does not check its expiry. */
export function readCredential(secrets: AccessSecrets, text: string): Credential | undefined {
  if (text.length > MAX_LENGTH) return undefined;
  const end = text.lastIndexOf('.');
  const signed = text.slice(0, end);
  const [, clientId = '', grantId = '', expires = '', holderId = clientId, ...more] =
    signed.split('.');
  if (more.length > 0 || !secrets.verify(signed, text.slice(end + 1))) return undefined;
  return { clientId, grantId, holderId, expiresMs: Number(expires) };
}
