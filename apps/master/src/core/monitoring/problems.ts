import { StatusProblemSeverity } from '@ubii/proto';
import type { Clock } from '@ubii/timing';
import { oneLine } from '@ubii/words';
import type { Client } from '../clients/client.ts';
import { LOST_AFTER_MS } from '../clients/liveness.ts';
import { clusterProblems } from './cluster-status.ts';
import { describeThrottle } from '../counters/throttle.ts';
import type { Core } from '../areas/core.ts';
import type { LimitName } from '../limits/index.ts';
import { quote } from '../texts/quote.ts';
import type { Problem } from '../checks/problem.ts';

/** Dependencies of the search for problems. */
export type ProblemContext = Pick<Core, 'clock' | 'limits' | 'limitWatch' | 'startedMs' | 'files'> &
  Pick<Core, 'sessions' | 'clients' | 'checks' | 'masters'>;

/** Problems told at most: what a page can show. */
const MAX_PROBLEMS = 100;

/** Limits of the whole master: all clients are affected when one is reached. */
const COMMON_LIMITS: ReadonlySet<LimitName> = new Set<LimitName>([
  'topics',
  'retainedBytes',
  'subscriptions',
  'devices',
  'queuesBytes',
  'clients',
  'sockets',
  'connections',
  'registrationBytes',
  'patterns',
  'profiles',
]);

/** Lists the current problems, most severe first [EX-18]. */
export function listProblems(core: ProblemContext): Problem[] {
  const problems = [...clusterProblems(core), ...limitProblems(core)];
  problems.push(...fileProblems(core), ...sessionProblems(core), ...core.checks.problems());
  for (const client of core.clients.values()) problems.push(...clientProblems(core, client));
  const { eventCharacters } = core.limits;
  return problems
    .sort((a, b) => b.severity - a.severity)
    .slice(0, MAX_PROBLEMS)
    .map((problem) => ({ ...problem, text: oneLine(problem.text, eventCharacters) })); // [EX-72]
}

function* limitProblems({ limitWatch, clock, limits }: ProblemContext): Iterable<Problem> {
  for (const { limit, streak, clientId } of limitWatch.hits()) {
    if (!streak.isOn(clock.monotonicMs())) continue;
    const isCommon = COMMON_LIMITS.has(limit);
    yield {
      code: 'limit_reached',
      severity: isCommon ? StatusProblemSeverity.ERROR : StatusProblemSeverity.WARNING,
      text: `The limit ${limit} (${limits[limit]}) was reached ${streak.count} times so far. Requests and records beyond it are refused.`,
      remedy: isCommon
        ? `Remove what is not needed, or raise the limit with --limits ${limit}=<number>.`
        : `Check whether the program does this on purpose. Otherwise reduce its load, or raise the limit with --limits ${limit}=<number>.`,
      clientId,
      sinceMs: epochMs(clock, streak.sinceMs),
    };
  }
}

/** [SE-23] */
function* fileProblems({ files, startedMs }: ProblemContext): Iterable<Problem> {
  for (const { where, reason } of files.broken()) {
    yield {
      code: 'file_broken',
      severity: StatusProblemSeverity.WARNING,
      text: `${where} cannot be read and is ignored: ${reason}`,
      remedy: 'Repair the file by hand, or remove it. The change applies at once.',
      sinceMs: startedMs,
    };
  }
}

/** [SE-12] */
function* sessionProblems({ sessions, clock }: ProblemContext): Iterable<Problem> {
  for (const session of sessions.list()) {
    if (session.life !== 'degraded') continue;
    const first = session.problems().find(({ isError }) => isError);
    yield {
      code: 'session_degraded',
      severity: StatusProblemSeverity.WARNING,
      text: `The session ${quote(session.label)} runs without some of its modules. ${first?.message ?? ''}`.trim(),
      remedy: 'Open the session to see which modules do not run and why.',
      sessionId: session.id,
      moduleId: first?.moduleId ?? '',
      sinceMs: epochMs(clock, session.lifeSinceMs),
    };
  }
}

function* clientProblems({ clock }: ProblemContext, client: Client): Iterable<Problem> {
  const nowMs = clock.monotonicMs();
  const { socket, label, protocolErrors, throttle, id: clientId } = client;
  const { outbox } = client.subscriber;
  const warning = { severity: StatusProblemSeverity.WARNING, clientId };
  // A client that closed its socket and stays away is an event, not a problem.
  if (client.status === 'inactive' || (client.status === 'unavailable' && socket !== undefined)) {
    const silentSeconds = Math.round((nowMs - client.lastSignMs) / 1000);
    const lostSeconds = LOST_AFTER_MS / 1000;
    const values =
      client.status === 'inactive'
        ? `After ${lostSeconds} s its retained values are deleted.`
        : `After ${lostSeconds} s its retained values were deleted, except those that it keeps longer.`; // [CL-13]
    yield {
      ...warning,
      code: 'client_silent',
      text: `${label} has sent nothing for ${silentSeconds} s. ${values}`,
      remedy: 'Check whether the device sleeps or lost its network. It reconnects automatically.',
      sinceMs: epochMs(clock, client.statusSinceMs),
    };
  }
  if (outbox.waitingCount > 0 || outbox.drops.isOn(nowMs)) {
    yield {
      ...warning,
      code: 'client_slow',
      text: `${label} receives data more slowly than it is published: ${outbox.drops.count} queued records were dropped so far. The newest value of each topic is kept.`,
      remedy: 'Subscribe to fewer topics or at a lower rate, or use a better network.',
      sinceMs: epochMs(clock, outbox.drops.isOn(nowMs) ? outbox.drops.sinceMs : nowMs),
    };
  }
  if (throttle !== undefined) {
    yield {
      ...warning,
      code: 'client_throttled', // [EX-33]
      text: `${label} is ${describeThrottle(throttle)}; ${throttle.dropped} of its records were dropped so far.`,
      remedy: throttle.byPolicy
        ? 'Publish less or at a lower rate. The throttle then ends automatically.'
        : 'Publish less, or remove the throttle.',
      sinceMs: throttle.sinceMs,
    };
  }
  if (protocolErrors.isOn(nowMs)) {
    yield {
      ...warning,
      code: 'protocol_errors',
      text: `${label} sent ${protocolErrors.count} messages so far that cannot be decoded. They were refused.`,
      remedy: 'The program uses another protocol or has a bug. Update it.',
      sinceMs: epochMs(clock, protocolErrors.sinceMs),
    };
  }
}

function epochMs(clock: Clock, thenMs: number): number {
  return clock.nowMs() - (clock.monotonicMs() - thenMs);
}
