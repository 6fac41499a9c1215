import { AccessRole, type AccessGrant } from '@ubii/proto';

/** What the host chooses for those who join. */
export interface GrantChoice {
  readonly target: string;
  readonly role: AccessRole;
  /** Milliseconds. */
  readonly lifetimeMs: number;
  /** How long those who joined may stay, milliseconds; 0 as long as others can join. [AC-91] */
  readonly stayMs: number;
}

const MINUTE_MS = 60_000;
const HOUR_MS = 60 * MINUTE_MS;
/** As long as a master lets anybody join with one grant. [AC-10] */
const LONGEST_MS = 30 * 24 * HOUR_MS;

export const ROLES = [
  { value: 'participant', text: 'Participant', role: AccessRole.ACCESS_ROLE_PARTICIPANT },
  { value: 'player', text: 'Player', role: AccessRole.ACCESS_ROLE_PLAYER },
  { value: 'viewer', text: 'Viewer', role: AccessRole.ACCESS_ROLE_VIEWER },
  { value: 'admin', text: 'Admin', role: AccessRole.ACCESS_ROLE_ADMIN },
] as const;
export type RoleChoice = (typeof ROLES)[number]['value'];

/** What a role may do, under the choice. */
export const ROLE_HINTS: Record<RoleChoice, string> = {
  participant: 'Uses and changes everything except who may join and how others are treated.',
  player: 'Takes part with its own sensors and topics; cannot open sessions, topics or clients.',
  viewer: 'Sees everything, changes nothing.',
  admin: 'May do everything, also let others in and throw them out.',
};

export const LIFETIMES = [
  { value: 'short', text: '15 minutes', lifetimeMs: 15 * MINUTE_MS },
  { value: 'day', text: '8 hours', lifetimeMs: 8 * HOUR_MS },
  { value: 'open', text: 'Until I take it back', lifetimeMs: LONGEST_MS },
] as const;
export type LifetimeChoice = (typeof LIFETIMES)[number]['value'];

export const STAYS = [
  { value: 'same', text: 'Until it ends', stayMs: 0 },
  { value: 'day', text: '12 hours', stayMs: 12 * HOUR_MS },
  { value: 'month', text: '30 days', stayMs: LONGEST_MS },
] as const;
export type StayChoice = (typeof STAYS)[number]['value'];

/** Pages that phones are sent to. */
export const TARGETS = [
  { value: '/devices/smart-device', text: 'Smart device' },
  { value: '/', text: 'Home' },
  { value: '/examples', text: 'Examples' },
  { value: '/examples/mouse-pointer', text: 'Pointer' },
  { value: '/topics', text: 'Topics' },
] as const;

/** The role in one word. */
export function grantRoleWord(role: AccessRole): string {
  return ROLES.find((one) => one.role === role)?.text ?? 'Nobody';
}

/** Whether somebody can join with it now. @param nowMs the master's clock */
export function isOpen(grant: AccessGrant, nowMs: number): boolean {
  const isUsedUp = grant.maxJoins > 0 && grant.joins >= grant.maxJoins;
  return grant.revokedMs === 0 && grant.expiresMs > nowMs && !isUsedUp;
}

/** A code that ends sooner than this is made anew, as a share of its lifetime. */
const LEAST_LEFT = 1 / 5;

/** The grant that was made for the same choice and still lasts long enough to be shown. */
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
      Math.abs(grant.expiresMs - grant.createdMs - choice.lifetimeMs) < MINUTE_MS &&
      Math.abs(grant.staysUntilMs - grant.createdMs - Math.max(choice.stayMs, choice.lifetimeMs)) <
        MINUTE_MS &&
      isOpen(grant, nowMs) &&
      grant.expiresMs - nowMs > choice.lifetimeMs * LEAST_LEFT &&
      hasSecret(grant.id),
  );
}

/** How long something lasts still: `12 min`, `7 h`, `29 d`. */
export function leftWord(ms: number): string {
  if (ms < HOUR_MS) return `${Math.max(1, Math.ceil(ms / MINUTE_MS))} min`;
  return ms < 48 * HOUR_MS ? `${Math.round(ms / HOUR_MS)} h` : `${Math.round(ms / 24 / HOUR_MS)} d`;
}

/** What was made with a grant, in words: `2 sessions (1 running), 1 module`; empty when nothing was. */
export function workWords({
  sessionIds,
  runningSessionIds,
  storedSessionNames,
  moduleNames,
}: AccessGrant): string {
  const count = (number: number, one: string): string =>
    number === 0 ? '' : `${number} ${one}${number === 1 ? '' : 's'}`;
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
