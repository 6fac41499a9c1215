import type { ClientCounters, ConnectionState, RoundTrip } from '@ubii/client-web';
import type { LogLine, MasterStatus, Session, SettingList, Limit } from '@ubii/proto';
import { sessionState, stateLook } from '../../sessions/state/session-state.ts';
import { limitRow } from '../limits/limit-row.ts';
import { lineText } from '../log/log-lines.ts';

/** Contents of a fault report; `undefined` for parts that are not available. */
export interface DiagnosticFacts {
  /** Time of the report, this computer's clock, epoch milliseconds. */
  readonly nowMs: number;
  readonly page: {
    readonly version: string | undefined;
    /** Path only: the query and hash may contain personal names. */
    readonly path: string;
    readonly userAgent: string;
    readonly screen: string;
    readonly language: string;
    readonly secure: boolean;
    readonly theme: string;
  };
  readonly connection: {
    readonly state: ConnectionState;
    readonly roundTrip: RoundTrip | undefined;
    readonly counters: ClientCounters;
  };
  readonly status: MasterStatus | undefined;
  readonly settings: SettingList | undefined;
  readonly limits: readonly Limit[] | undefined;
  readonly sessions: readonly Session[] | undefined;
  readonly log: readonly LogLine[] | undefined;
}

/**
 * Formats the facts as JSON. Selected one by one, so that nothing else is included: no tokens, no ids of this page, no
 * code of modules, no topic data.
 */
export function diagnosticsText(facts: DiagnosticFacts): string {
  const { nowMs, page, connection, settings, limits, sessions, log } = facts;
  const { state, roundTrip, counters } = connection;
  const report = {
    made: new Date(nowMs).toISOString(),
    page,
    connection: {
      status: state.status,
      error: 'error' in state ? state.error?.message : undefined,
      roundTrip,
      counters,
    },
    master: facts.status && masterFacts(facts.status),
    startedWith: settings && {
      runtime: settings.runtime,
      flags: settings.elements.map(({ flag, value, given }) => ({ flag, value, given })),
    },
    limits: limits?.filter(({ use, hits }) => hits > 0 || (use?.value ?? 0) > 0).map(limitFacts),
    sessions: sessions?.map(sessionFacts),
    log: log?.map(lineText),
  };
  return `${JSON.stringify(report, undefined, 2)}\n`;
}

function masterFacts(status: MasterStatus): object {
  const { version, startedMs, nowMs, processors, busyPercent, delayMs } = status;
  const { cpuPercent, memoryBytes, recordsIn, recordsOut, dropped, refused, topics } = status;
  const { clientsActive, clientsInactive, clientsUnavailable } = status;
  return {
    version,
    upSeconds: Math.round((nowMs - startedMs) / 1000),
    processors,
    busyPercent,
    delayMs,
    cpuPercent,
    memoryBytes,
    recordsIn,
    recordsOut,
    dropped,
    refused,
    topics,
    clients: { active: clientsActive, silent: clientsInactive, away: clientsUnavailable },
    problems: status.problems.map(({ code, text, remedy, sinceMs }) => ({
      code,
      text,
      remedy,
      since: new Date(sinceMs).toISOString(),
    })),
  };
}

function limitFacts(limit: Limit): object {
  const { name, value, unit, use, hits } = limit;
  return { name, value, unit, used: use?.value, hits, state: limitRow(limit).state };
}

function sessionFacts(session: Session): object {
  return {
    name: session.name,
    state: stateLook(sessionState(session)).word,
    modules: session.processingModules.length,
    problems: (session.extension?.problems ?? []).map(({ code, message }) => ({ code, message })),
  };
}
