import {
  globToRegExpSource,
  JoinProblem,
  ServiceError,
  RevokedWork,
  type AccessGrant,
  type AccessGrantCreateRequest,
  type AccessRole,
  type Init,
  type TakenMark,
} from '@ubii/proto';
import { isLongerThan, oneLine } from '@ubii/words';
import { isUsedUp } from '../access/access.ts';
import { grantOf, type Caller } from '../access/caller.ts';
import {
  clientIdsOf,
  endGrant,
  withDescendants,
  workOf,
  type GrantWorkContext,
} from './grant-work.ts';
import { grantMessage, type Grant, type GrantSpec } from '../access/grant.ts';
import { joinRefusal } from '../access/join-refusals.ts';
import { ADMINS, givenRole, wireRole } from '../access/roles.ts';
import type { Core } from '../areas/core.ts';
import type { Dismissal } from '../clients/dismissals.ts';
import { placeOf } from '../clients/marks.ts';
import { nameOf } from '../areas/settings.ts';
import { quote } from '../texts/quote.ts';
import { byCaller } from './by-caller.ts';
import { definer } from './define-service.ts';
import type { ServiceCall } from './service-call.ts';

type Context = GrantWorkContext & Pick<Core, 'settings' | 'limits' | 'patterns'>;
const define = definer<keyof Context>();

const HOUR_MS = 3_600_000;
const DEFAULT_LIFETIME_MS = 12 * HOUR_MS;
const MAX_LIFETIME_MS = 30 * 24 * HOUR_MS;
/** A code can be guessed in the long run [AC-11]. */
const CODE_LIFETIME_MS = 12 * HOUR_MS;
const MAX_JOINS = 100_000;
const MAX_TOPICS = 16;
/** A path on this origin: `//host` and `/\\host` would be another. */
const TARGET = /^\/(?![/\\])[^\s\\]*$/;

/** Services on who may join, and as what. */
export const ACCESS_SERVICES = [
  // [AC-16]
  define('joinCheck', {
    roles: 'anyone',
    handle(core, { token }, call) {
      const masterName = nameOf(core.settings);
      const { grant, problem, role, expiresMs } =
        token === '' ? ofCaller(call) : ofToken(core, token, call);
      if (grant === undefined && role === undefined) {
        const why = problem ?? JoinProblem.JOIN_PROBLEM_MISSING;
        return { problem: why, message: joinRefusal(why).message, masterName };
      }
      const isJoined = grant !== undefined && isOfGrant(call, grant);
      const marks = marksFor(core, call);
      return {
        role: role!,
        target: grant?.target ?? '',
        expiresMs,
        masterName,
        isJoined,
        ...marks,
      };
    },
  }),
  // [AC-10]
  define('accessGrantCreate', {
    roles: ADMINS,
    subject: ({ clientId }) => clientId,
    auditObject: (_core, { label }) => label,
    async handle(core, wanted, { caller }) {
      const spec = specOf(core, wanted, caller);
      const staysUntilMs = core.clock.nowMs() + wanted.stayMs;
      const { grant, token, code } = await core.access.grants.create(spec, staysUntilMs);
      core.log.info('invitation created', {
        invitation: grant.label || grant.id,
        role: grant.role,
      });
      return { grant: messageOf(core, grant), token, code };
    },
  }),
  // [AC-14]
  define('accessGrantList', {
    roles: ADMINS,
    handle: (core) => ({
      elements: core.access.grants.list().map((grant) => messageOf(core, grant)),
    }),
  }),
  // [AC-15]
  define('accessGrantRevoke', {
    roles: ADMINS,
    subject: ({ clientId }) => clientId,
    auditObject: ({ access }, { grantId }) => access.grants.get(grantId)?.label || grantId,
    async handle(core, payload) {
      const { clientId, grantId, reason, work } = payload;
      const grant = core.access.grants.get(grantId);
      if (grant === undefined) {
        throw new ServiceError('not_found', `No invitation has the id ${quote(grantId)}.`);
      }
      // Revoke at once, before the change is written, so that no request comes in between.
      const told: Dismissal = {
        reason: 'revoked',
        explanation: byCaller(core, clientId, reason),
      };
      const isHandedOver = work === RevokedWork.REVOKED_WORK_HAND_OVER;
      await Promise.all(
        withDescendants(core, grant).map(async (one) => {
          const revoked = core.access.grants.revoke(one, isHandedOver);
          await endGrant(core, one, told, isHandedOver);
          core.log.info('invitation revoked', {
            invitation: one.label || one.id,
            joins: one.joins,
          });
          await revoked;
        }),
      );
      return messageOf(core, grant);
    },
  }),
];

function messageOf(core: Context, grant: Grant): Init<AccessGrant> {
  return grantMessage(grant, clientIdsOf(core, grant), workOf(core, grant));
}

/** What a person who joins can choose from. [EX-100] */
function marksFor({ clients }: Context, { caller }: ServiceCall) {
  const ownId = caller.kind === 'client' ? caller.clientId : undefined;
  const taken = new Map<number, Init<TakenMark>>();
  for (const { id, status, spec, mark } of clients.values()) {
    if (id === ownId || status === 'unavailable' || mark === undefined) continue;
    taken.set(placeOf(mark), { name: spec.name, mark });
  }
  return { freeMark: clients.freeMark(), takenMarks: [...taken.values()] };
}

interface Checked {
  readonly grant?: Grant | undefined;
  readonly problem?: JoinProblem | undefined;
  readonly role?: AccessRole | undefined;
  readonly expiresMs?: number;
}

function ofToken({ access }: Context, token: string, call: ServiceCall): Checked {
  const { grant, problem } = access.check(token, call.facts);
  if (grant === undefined) return { problem };
  if (isUsedUp(grant) && !isOfGrant(call, grant)) return { problem: JoinProblem.JOIN_PROBLEM_USED };
  return { grant, role: wireRole(grant.role), expiresMs: grant.closedMs };
}

/** Whether the caller is one of those who have joined with it. */
function isOfGrant({ caller }: ServiceCall, grant: Grant): boolean {
  return caller.kind === 'client' && caller.grant === grant;
}

function ofCaller({ caller }: ServiceCall): Checked {
  switch (caller.kind) {
    case 'stranger':
      return { problem: caller.refusal.details['joinProblem'] as JoinProblem };
    case 'joining':
      return isUsedUp(caller.grant)
        ? { problem: JoinProblem.JOIN_PROBLEM_USED }
        : {
            grant: caller.grant,
            role: wireRole(caller.grant.role),
            expiresMs: caller.grant.closedMs,
          };
    case 'client':
      return { grant: caller.grant, role: wireRole(caller.role), expiresMs: caller.expiresMs };
    default:
      return { role: wireRole(caller.role), expiresMs: 0 };
  }
}

/** @throws ServiceError for what no grant can be */
function specOf(core: Context, wanted: AccessGrantCreateRequest, caller: Caller): GrantSpec {
  const { label, target, lifetimeMs, maxJoins, readTopics, writeTopics, stayMs } = wanted;
  const role = givenRole(wanted.role);
  if (role === undefined)
    throw invalid('role', 'is one of the roles admin, participant, player and viewer');
  const { nameCharacters } = core.limits;
  if (label !== oneLine(label, nameCharacters)) {
    throw invalid('label', `has at most ${nameCharacters} characters on one line`);
  }
  if (target !== '' && !TARGET.test(target)) {
    throw invalid('target', 'is a path on this master, such as /devices, or empty');
  }
  if (!(lifetimeMs >= 0 && lifetimeMs <= MAX_LIFETIME_MS)) {
    throw invalid('lifetime_ms', `is from 0 to ${MAX_LIFETIME_MS}`);
  }
  if (!(stayMs >= 0 && stayMs <= MAX_LIFETIME_MS)) {
    throw invalid('stay_ms', `is from 0 to ${MAX_LIFETIME_MS}`);
  }
  if (maxJoins < 0 || maxJoins > MAX_JOINS) throw invalid('max_joins', `is from 0 to ${MAX_JOINS}`);
  requireGlobs(core, 'read_topics', role, readTopics);
  requireGlobs(core, 'write_topics', role, writeTopics);
  const nowMs = core.clock.nowMs();
  const lifeMs = lifetimeMs || DEFAULT_LIFETIME_MS;
  return {
    label,
    role,
    target,
    expiresMs: nowMs + lifeMs,
    codeExpiresMs: nowMs + Math.min(lifeMs, CODE_LIFETIME_MS),
    maxJoins,
    readTopics,
    writeTopics,
    isTerminal: false,
    terminalOf: '',
    hereOnly: false,
    madeWith: grantOf(caller),
  };
}

function requireGlobs(
  { limits, patterns }: Context,
  member: string,
  role: string,
  globs: readonly string[],
): void {
  if (globs.length === 0) return;
  if (role !== 'player') throw invalid(member, 'applies to players only');
  if (globs.length > MAX_TOPICS) throw invalid(member, `has at most ${MAX_TOPICS} elements`);
  for (const glob of globs) {
    if (glob === '' || isLongerThan(glob, limits.topicBytes)) {
      throw invalid(member, `has globs of 1 to ${limits.topicBytes} bytes`);
    }
    try {
      patterns.compile(globToRegExpSource(glob));
    } catch (cause) {
      const reason = cause instanceof Error ? cause.message : String(cause);
      throw invalid(member, `has globs that can be used, but ${quote(glob)} cannot: ${reason}`);
    }
  }
}

function invalid(member: string, expected: string): ServiceError {
  return new ServiceError(
    'invalid_argument',
    `The member access_grant_create_request.${member} ${expected}.`,
    { details: { member } },
  );
}
