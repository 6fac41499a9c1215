import {
  fromJson,
  SessionState,
  SessionStatus,
  type Session,
  type SessionStatistics,
} from '@ubii/proto';
import { sessionTotals, type SessionTotals } from '../live/session-totals.ts';
import type { SessionMaster } from '../words/master-words.ts';
import type { SharedTopic } from '../words/shared-topics.ts';
import { isAlive, sessionState, stateLook, type StateLook } from '../state/session-state.ts';

/** Filter of the list. */
export type SessionFilter = 'all' | 'running' | 'stopped' | 'problems';

/** Session in the list, with the data of its row. */
export interface SessionRow {
  readonly session: Session;
  readonly state: SessionState;
  readonly look: StateLook;
  /** `undefined` without statistics. */
  readonly totals: SessionTotals | undefined;
  /** Ids of the nodes of its modules, without duplicates. */
  readonly nodeIds: readonly string[];
  readonly errors: number;
  readonly warnings: number;
  /** The most important problem, one sentence. */
  readonly problem: string | undefined;
  /** Topics that other running sessions write, too. */
  readonly shared: readonly SharedTopic[];
  /** This browser stores unsaved changes of it. */
  readonly hasDraft: boolean;
  /** Where it runs; `undefined` unless there are several masters. */
  readonly master: SessionMaster | undefined;
}

/** Data of a row that the session itself does not have. */
export type RowSurroundings = Pick<SessionRow, 'shared' | 'hasDraft' | 'master'>;
const ALONE: RowSurroundings = { shared: [], hasDraft: false, master: undefined };

export function sessionRow(
  session: Session,
  statistics: SessionStatistics | undefined,
  around: RowSurroundings = ALONE,
): SessionRow {
  const state = sessionState(session);
  const problems = session.extension?.problems ?? [];
  const errors = problems.filter(({ isError }) => isError);
  return {
    session,
    state,
    look: rowLook(state, errors.length > 0),
    totals: statistics && isAlive(session) ? sessionTotals(statistics) : undefined,
    nodeIds: [...new Set(session.processingModules.map(({ nodeId }) => nodeId))].filter(
      (id) => id !== '',
    ),
    errors: errors.length,
    warnings: problems.length - errors.length,
    problem: (errors[0] ?? problems[0])?.message,
    ...around,
  };
}

/** A running session with an error has the look of a problem. */
function rowLook(state: SessionState, hasError: boolean): StateLook {
  const look = stateLook(state);
  return hasError && look.mark === 'live' ? { ...look, mark: 'warning' } : look;
}

/** Appends stored sessions that are not open; they are opened by id. [SE-27] */
export function withStored(
  sessions: readonly Session[],
  stored: readonly Session[],
): readonly Session[] {
  const ids = new Set(sessions.map(({ id }) => id));
  const names = new Set(
    sessions.filter(({ extension }) => extension?.stored).map(({ name }) => name),
  );
  const rest = stored.filter(({ id, name }) => !ids.has(id) && !names.has(name));
  return [...sessions, ...rest.map(asStored)];
}

function asStored(session: Session): Session {
  const { extension } = fromJson('ubii.sessions.Session', { extension: { stored: true } });
  return {
    ...session,
    status: SessionStatus.STOPPED,
    extension: {
      ...extension!,
      ...session.extension,
      state: SessionState.SESSION_STOPPED,
      problems: [],
      stored: true,
    },
  };
}

/**
 * Returns the rows that match search and filter: running ones first, then by name.
 * @param search words that must all occur in name, description, tags, names of modules or that of the master
 */
export function filterRows(
  rows: readonly SessionRow[],
  search: string,
  filter: SessionFilter,
): SessionRow[] {
  const words = search.toLowerCase().split(/\s+/).filter(Boolean);
  return rows
    .filter((row) => fitsFilter(row, filter))
    .filter(({ session, master }) => {
      const text = searchText(session, master?.label ?? '');
      return words.every((word) => text.includes(word));
    })
    .sort(
      (a, b) =>
        Number(isAlive(b.session)) - Number(isAlive(a.session)) ||
        a.session.name.localeCompare(b.session.name) ||
        a.session.id.localeCompare(b.session.id),
    );
}

function fitsFilter(row: SessionRow, filter: SessionFilter): boolean {
  const { session, errors, warnings, shared } = row;
  switch (filter) {
    case 'all':
      return true;
    case 'running':
      return isAlive(session);
    case 'stopped':
      return !isAlive(session);
    case 'problems':
      return errors + warnings + shared.length > 0;
  }
}

function searchText(session: Session, master: string): string {
  const { name, description, tags, authors, processingModules } = session;
  const modules = processingModules.map((module) => module.name);
  return [name, description, ...tags, ...authors, ...modules, master].join(' ').toLowerCase();
}
