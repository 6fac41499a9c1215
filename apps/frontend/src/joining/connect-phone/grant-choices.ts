import { AccessRole, type AccessGrant } from '@ubii/proto';
import { counted, plural } from '@ubii/words';

/** Options of the host for an invitation. */
export interface GrantChoice {
  readonly target: string;
  readonly role: AccessRole;
  /** Milliseconds. */
  readonly lifetimeMs: number;
  /** Time for which joined clients stay connected, milliseconds; 0: as long as the invitation is open. [AC-91] */
  readonly stayMs: number;
  /** For players: globs of topics they may read besides their own. @default none */
  readonly readTopics?: readonly string[];
}

const MINUTE_MS = 60_000;
const HOUR_MS = 60 * MINUTE_MS;
/** The longest lifetime that a master accepts. [AC-10] */
const LONGEST_MS = 30 * 24 * HOUR_MS;

/** What clients may do, as the host chooses it (`may`), and the name of the role. */
export const ROLES = [
  {
    value: 'participant',
    text: 'Participant',
    may: 'Take part',
    role: AccessRole.ACCESS_ROLE_PARTICIPANT,
  },
  { value: 'player', text: 'Player', may: 'Send only', role: AccessRole.ACCESS_ROLE_PLAYER },
  { value: 'viewer', text: 'Viewer', may: 'Watch', role: AccessRole.ACCESS_ROLE_VIEWER },
  { value: 'admin', text: 'Admin', may: 'Everything', role: AccessRole.ACCESS_ROLE_ADMIN },
] as const;
export type RoleChoice = (typeof ROLES)[number]['value'];

/** Description of a role, below the option. */
export const ROLE_HINTS: Record<RoleChoice, string> = {
  participant: 'Participant: uses and changes everything except invitations and other clients.',
  player: 'Player: sends its own sensors and touches. Cannot open sessions, topics or clients.',
  viewer: 'Viewer: sees everything and changes nothing.',
  admin: 'Admin: does everything, including inviting and disconnecting other clients.',
};

export const LIFETIMES = [
  { value: 'short', text: '15 minutes', lifetimeMs: 15 * MINUTE_MS },
  { value: 'day', text: '8 hours', lifetimeMs: 8 * HOUR_MS },
  { value: 'open', text: 'Until revoked', lifetimeMs: LONGEST_MS },
] as const;
export type LifetimeChoice = (typeof LIFETIMES)[number]['value'];

export const STAYS = [
  { value: 'same', text: 'As long as the code', stayMs: 0 },
  { value: 'day', text: '12 hours', stayMs: 12 * HOUR_MS },
  { value: 'month', text: '30 days', stayMs: LONGEST_MS },
] as const;
export type StayChoice = (typeof STAYS)[number]['value'];

/** Pages that phones can be sent to. */
export const TARGETS = [
  { value: '/devices/smart-device', text: 'Smart device' },
  { value: '/', text: 'Home' },
  { value: '/examples', text: 'Examples' },
  { value: '/examples/mouse-pointer', text: 'Pointer' },
  { value: '/topics', text: 'Topics' },
] as const;

/** Name of a role. */
export function grantRoleWord(role: AccessRole): string {
  return ROLES.find((one) => one.role === role)?.text ?? 'No role';
}

/** Returns whether a client can join with it now. @param nowMs the master's clock */
export function isOpen(grant: AccessGrant, nowMs: number): boolean {
  const isUsedUp = grant.maxJoins > 0 && grant.joins >= grant.maxJoins;
  return grant.revokedMs === 0 && grant.expiresMs > nowMs && !isUsedUp;
}

/** Remaining share of the lifetime below which an invitation is replaced by a new one. */
const MIN_LEFT = 1 / 5;

/** Returns an invitation with the same options that is valid long enough to be shown. */
export function reusable(
  grants: readonly AccessGrant[],
  choice: GrantChoice,
  nowMs: number,
  hasSecret: (id: string) => boolean,
): AccessGrant | undefined {
  return grants.find(
    (grant) =>
      grant.role === choice.role &&
      grant.target === choice.target &&
      grant.readTopics.join(' ') === (choice.readTopics ?? []).join(' ') &&
      Math.abs(grant.expiresMs - grant.createdMs - choice.lifetimeMs) < MINUTE_MS &&
      Math.abs(grant.staysUntilMs - grant.createdMs - Math.max(choice.stayMs, choice.lifetimeMs)) <
        MINUTE_MS &&
      isOpen(grant, nowMs) &&
      grant.expiresMs - nowMs > choice.lifetimeMs * MIN_LEFT &&
      hasSecret(grant.id),
  );
}

/** Formats the remaining time: `12 min`, `7 h`, `29 d`. */
export function leftWord(ms: number): string {
  if (ms < HOUR_MS) return `${Math.max(1, Math.ceil(ms / MINUTE_MS))} min`;
  return ms < 48 * HOUR_MS ? `${Math.round(ms / HOUR_MS)} h` : `${Math.round(ms / 24 / HOUR_MS)} d`;
}

/** Formats the number of clients that use or used an invitation: `2 connected`. */
export function usedWords({ joins, clientIds }: AccessGrant): string {
  if (clientIds.length > 0) return `${clientIds.length} connected`;
  return joins === 0 ? 'not used yet' : `used ${plural(joins, 'once', `${joins} times`)}`;
}

/** Lists what was created with an invitation: `2 sessions (1 running), 1 module`; empty for nothing. */
export function workWords({
  sessionIds,
  runningSessionIds,
  storedSessionNames,
  moduleNames,
}: AccessGrant): string {
  const count = (number: number, one: string): string => (number === 0 ? '' : counted(number, one));
  const running = runningSessionIds.length;
  const runs = running === 0 ? '' : ` (${running} running)`;
  const sessions = count(sessionIds.length, 'session');
  return [
    sessions && `${sessions}${runs}`,
    count(storedSessionNames.length, 'stored session'),
    count(moduleNames.length, 'module'),
  ]
    .filter(Boolean)
    .join(', ');
}
