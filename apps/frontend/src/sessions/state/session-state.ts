import { SessionState, SessionStatus, type Session } from '@ubii/proto';
import type { MarkedState } from '../../ui/UiStateMark.vue';

/** What can be done with the life of a session. */
export type LifeAction = 'start' | 'pause' | 'resume' | 'stop' | 'restart';

/** Where a session is in its life, for people. */
export interface StateLook {
  readonly mark: MarkedState;
  readonly word: string;
  /** What can be done now, the likeliest first. [SE-10] */
  readonly actions: readonly LifeAction[];
}

const { SESSION_CREATED, SESSION_STARTING, SESSION_RUNNING } = SessionState;
const { SESSION_DEGRADED, SESSION_PAUSED, SESSION_STOPPING, SESSION_STOPPED } = SessionState;

const LOOKS: Readonly<Record<SessionState, StateLook>> = {
  [SESSION_CREATED]: { mark: 'stopped', word: 'Not started', actions: ['start'] },
  [SESSION_STARTING]: { mark: 'away', word: 'Starting', actions: ['stop'] },
  [SESSION_RUNNING]: { mark: 'live', word: 'Running', actions: ['pause', 'stop', 'restart'] },
  [SESSION_DEGRADED]: { mark: 'warning', word: 'Degraded', actions: ['pause', 'stop', 'restart'] },
  [SESSION_PAUSED]: { mark: 'paused', word: 'Paused', actions: ['resume', 'stop', 'restart'] },
  [SESSION_STOPPING]: { mark: 'away', word: 'Stopping', actions: [] },
  [SESSION_STOPPED]: { mark: 'stopped', word: 'Stopped', actions: ['start'] },
};

/** By the status alone, as an original master says it. */
const STATES: Readonly<Record<SessionStatus, SessionState>> = {
  [SessionStatus.CREATED]: SESSION_CREATED,
  [SessionStatus.RUNNING]: SESSION_RUNNING,
  [SessionStatus.PAUSED]: SESSION_PAUSED,
  [SessionStatus.STOPPED]: SESSION_STOPPED,
};

type Living = Pick<Session, 'status' | 'extension'>;

export function sessionState({ status, extension }: Living): SessionState {
  return extension?.state ?? STATES[status] ?? SESSION_CREATED;
}

export function stateLook(state: SessionState): StateLook {
  return LOOKS[state] ?? LOOKS[SESSION_CREATED];
}

/** What runs is not known while the master cannot be asked: nothing is shown as running then. */
export const OUT_OF_CONTACT: StateLook = {
  mark: 'away',
  word: 'Not connected to the master',
  actions: [],
};

/** How a session looks on a page that may have lost the master since it heard of it. */
export function lookNow(session: Living, isConnected: boolean): StateLook {
  return isConnected ? sessionLook(session) : OUT_OF_CONTACT;
}

/** True while its modules run, or should: also while it is held. */
export function isAlive(session: Living): boolean {
  const state = sessionState(session);
  return state === SESSION_RUNNING || state === SESSION_DEGRADED || state === SESSION_PAUSED;
}

/** True when its modules are reported of: they run, or start and may load models. [SE-50] [PM-94] */
export const isWatched = (session: Living): boolean =>
  isAlive(session) || sessionState(session) === SESSION_STARTING;

/** True when it runs, or should, and something keeps it from doing so well. */
export function hasTrouble(session: Living): boolean {
  const hasError = session.extension?.problems.some(({ isError }) => isError) === true;
  return hasError && (isAlive(session) || sessionState(session) === SESSION_STARTING);
}

/** How it is: what runs with an error does not look as if all were well. */
export function sessionLook(session: Living): StateLook {
  const look = stateLook(sessionState(session));
  return look.mark === 'live' && hasTrouble(session)
    ? { ...look, mark: 'warning', word: 'Running with errors' }
    : look;
}

export const ACTION_WORDS: Readonly<Record<LifeAction, string>> = {
  start: 'Start',
  pause: 'Pause',
  resume: 'Resume',
  stop: 'Stop',
  restart: 'Restart',
};

/** The session as it is when the master does not have it any more: nothing of it runs. */
export function sessionAtRest(session: Session): Session {
  const { extension } = session;
  return {
    ...session,
    status: SessionStatus.CREATED,
    extension: extension && { ...extension, state: SESSION_CREATED, problems: [] },
  };
}
