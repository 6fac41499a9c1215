import type { AccessGrant, Init, JsonObject } from '@ubii/proto';
import { isGivenRole, wireRole, type GivenRole } from './roles.ts';

declare const GRANT: unique symbol;

/** Id of a grant. A client without one has `undefined`. */
export type GrantId = string & { readonly [GRANT]: true };

/** Reads an id from outside; undefined for an empty one. */
export function toGrantId(text: string): GrantId | undefined {
  return text === '' ? undefined : (text as GrantId);
}

/** Reads ids from outside. */
export function toGrantIds(texts: readonly string[] = []): GrantId[] {
  return texts.flatMap((text) => toGrantId(text) ?? []);
}

/** Fixed properties of a grant. Times are epoch milliseconds. */
export interface GrantSpec {
  readonly label: string;
  readonly role: GivenRole;
  /** Path of the page that opens after joining; empty for the start page. */
  readonly target: string;
  readonly expiresMs: number;
  readonly codeExpiresMs: number;
  /** 0 for any number. */
  readonly maxJoins: number;
  /** Globs. */
  readonly readTopics: readonly string[];
  readonly writeTopics: readonly string[];
  /** The master made it itself, for its terminal [AC-19]. */
  readonly isTerminal: boolean;
  /** The grant and its credentials are valid only on the master's machine [AC-43]. */
  readonly hereOnly: boolean;
  /** The grant of the client that made it, with which it ends; undefined for the operator's [AC-93]. */
  readonly madeWith: GrantId | undefined;
  /** The installation whose terminal it is of; empty for all others, and for a master that is alone. [CU-27] */
  readonly terminalOf: string;
}

/** An invitation: lets clients join [AC-10]. */
export interface Grant extends GrantSpec {
  readonly id: GrantId;
  readonly createdMs: number;
  /** Keyed hashes of its secrets [AC-11], which change where each start shows new ones [AC-42]. */
  token: string;
  code: string;
  expiresMs: number;
  codeExpiresMs: number;
  /** 0 while it stands. */
  revokedMs: number;
  /** What was made with it went to the operator when it was revoked, and did not stop [AC-92]. */
  isHandedOver: boolean;
  joins: number;
  /** The end of the last of its credentials; 0 when it gave none. */
  credentialsEndMs: number;
  /** End of joining with the grant: its expiry, or the end of the master's run that it was for. */
  closedMs: number;
  /** End of the stay of clients that joined with it [AC-91]. */
  staysUntilMs: number;
  /** Its time was over, and those who had joined were ended [AC-91]. */
  isOver: boolean;
}

/** Sessions and modules that were created or changed with a grant [AC-90]. */
export interface GrantWork {
  readonly sessionIds: readonly string[];
  readonly runningSessionIds: readonly string[];
  readonly storedSessionNames: readonly string[];
  readonly moduleNames: readonly string[];
}

/** The grant as others may see it. */
export function grantMessage(
  grant: Grant,
  clientIds: readonly string[],
  work: GrantWork,
): Init<AccessGrant> {
  const { id, label, role, target, createdMs, maxJoins, readTopics, writeTopics } = grant;
  const { codeExpiresMs, revokedMs, joins, isTerminal, closedMs, staysUntilMs } = grant;
  return {
    id,
    label,
    role: wireRole(role),
    target,
    createdMs,
    expiresMs: closedMs,
    maxJoins,
    readTopics: [...readTopics],
    writeTopics: [...writeTopics],
    revokedMs,
    joins,
    clientIds: [...clientIds],
    isTerminal,
    codeExpiresMs: Math.min(codeExpiresMs, closedMs),
    staysUntilMs,
    ...copied(work),
  };
}

function copied({ sessionIds, runningSessionIds, storedSessionNames, moduleNames }: GrantWork) {
  return {
    sessionIds: [...sessionIds],
    runningSessionIds: [...runningSessionIds],
    storedSessionNames: [...storedSessionNames],
    moduleNames: [...moduleNames],
  };
}

/** The grant as it is kept [AC-19]. */
export function grantToJson(grant: Grant): JsonObject {
  const { readTopics, writeTopics, madeWith = '', ...rest } = grant;
  return { ...rest, madeWith, readTopics: [...readTopics], writeTopics: [...writeTopics] };
}

/** Members that grants of earlier versions do not have. */
type LaterMember = 'hereOnly' | 'madeWith' | 'staysUntilMs' | 'isOver' | LaterOfCluster;
type LaterOfCluster = 'terminalOf' | 'isHandedOver';

/** A grant as it was kept; undefined when this is none. */
export function grantFromJson(json: unknown): Grant | undefined {
  if (typeof json !== 'object' || json === null) return undefined;
  const kept = json as { readonly [M in keyof Grant]?: unknown };
  const texts = [kept.id, kept.label, kept.target, kept.token, kept.code];
  const numbers = [
    ...[kept.createdMs, kept.expiresMs, kept.codeExpiresMs, kept.maxJoins, kept.revokedMs],
    ...[kept.joins, kept.credentialsEndMs, kept.closedMs],
  ];
  const isGrant =
    texts.every((text) => typeof text === 'string') &&
    numbers.every((number) => typeof number === 'number' && Number.isFinite(number)) &&
    isGivenRole(kept.role) &&
    typeof kept.isTerminal === 'boolean' &&
    (kept.hereOnly === undefined || typeof kept.hereOnly === 'boolean') &&
    (kept.madeWith === undefined || typeof kept.madeWith === 'string') &&
    (kept.terminalOf === undefined || typeof kept.terminalOf === 'string') &&
    (kept.isHandedOver === undefined || typeof kept.isHandedOver === 'boolean') &&
    (kept.staysUntilMs === undefined || Number.isFinite(kept.staysUntilMs)) &&
    isTextList(kept.readTopics) &&
    isTextList(kept.writeTopics);
  if (!isGrant) return undefined;
  const grant = json as Omit<Grant, LaterMember> & Partial<Pick<Grant, LaterMember>>;
  const { madeWith = '' } = kept as { readonly madeWith?: string };
  // Grants of earlier versions are good everywhere, and last as long as what they gave.
  const staysUntilMs = Math.max(grant.expiresMs, grant.credentialsEndMs);
  return {
    hereOnly: false,
    isOver: false,
    terminalOf: '',
    isHandedOver: false,
    staysUntilMs,
    ...grant,
    madeWith: toGrantId(madeWith),
  };
}

function isTextList(value: unknown): value is readonly string[] {
  return Array.isArray(value) && value.every((text) => typeof text === 'string');
}
