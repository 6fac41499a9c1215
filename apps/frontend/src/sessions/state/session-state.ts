import { SessionState, SessionStatus, type Session } from '@ubii/proto';
import type { MarkedState } from '../../ui/UiStateMark.vue';

/** Actions that change the status of a session. */
export type LifeAction = 'start' | 'pause' | 'resume' | 'stop' | 'restart';

/** Display of a session's status. */
export interface StateLook {
  readonly mark: MarkedState;
  readonly word: string;
  /** Actions available now, most likely first. [SE-10] */
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

/** From the status only, as original masters report it. */
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

/** Shown while disconnected: the real status is unknown, so nothing is shown as running. */
export const OUT_OF_CONTACT: StateLook = {
  mark: 'away',
  word: 'Not connected to the master',
  actions: [],
};

/** Status of a session on a page that may be disconnected from the master. */
export function lookNow(session: Living, isConnected: boolean): StateLook {
  return isConnected ? sessionLook(session) : OUT_OF_CONTACT;
}

/** True while its modules run or should run, also when paused. */
export function isAlive(session: Living): boolean {
  const state = sessionState(session);
  return state === SESSION_RUNNING || state === SESSION_DEGRADED || state === SESSION_PAUSED;
}

/** True when the modules have statistics: they run, or are starting and may load models. [SE-50] [PM-94] */
export const isWatched = (session: Living): boolean =>
  isAlive(session) || sessionState(session) === SESSION_STARTING;

/** True when it runs, or should, and has a problem. */
export function hasTrouble(session: Living): boolean {
  const hasError = session.extension?.problems.some(({ isError }) => isError) === true;
  return hasError && (isAlive(session) || sessionState(session) === SESSION_STARTING);
}

/** Status of a session; a running session with an error has the look of a problem. */
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

/** The session in the state of one that the master does not have: nothing runs. */
export function sessionAtRest(session: Session): Session {
  const { extension } = session;
  return {
    ...session,
    status: SessionStatus.CREATED,
    extension: extension && { ...extension, state: SESSION_CREATED, problems: [] },
  };
}
