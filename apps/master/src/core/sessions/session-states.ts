import { SessionState, SessionStatus } from '@ubii/proto';

/** Life cycle state of a session. [SE-10] */
export type SessionLife =
  | 'created'
  | 'starting'
  | 'running'
  | 'degraded'
  | 'paused'
  | 'stopping'
  | 'stopped';

/** Events of a session. */
export type SessionEvent =
  /** A client starts it. */
  | 'start'
  /** All its modules run. */
  | 'all run'
  /** Some of its modules run, and the others will not or not yet. */
  | 'some run'
  /** A client pauses it [SE-14]. */
  | 'pause'
  | 'resume'
  /** A client stops it, or none of its modules could be started. */
  | 'stop'
  /** All its modules have ended, or are no longer waited for. */
  | 'all ended';

/** Every legal move; what is not here changes nothing. */
const MOVES: { readonly [S in SessionLife]: { readonly [E in SessionEvent]?: SessionLife } } = {
  created: { start: 'starting' },
  starting: { 'all run': 'running', 'some run': 'degraded', stop: 'stopping' },
  running: { 'some run': 'degraded', pause: 'paused', stop: 'stopping' },
  degraded: { 'all run': 'running', pause: 'paused', stop: 'stopping' },
  paused: { resume: 'running', stop: 'stopping' },
  stopping: { 'all ended': 'stopped' },
  stopped: { start: 'starting' },
};

export function nextLife(life: SessionLife, event: SessionEvent): SessionLife {
  return MOVES[life][event] ?? life;
}

/** Every state. */
export const SESSION_LIVES = Object.keys(MOVES) as SessionLife[];

/** Whether the event means something in this state. */
export function canHappen(life: SessionLife, event: SessionEvent): boolean {
  return MOVES[life][event] !== undefined;
}

/** Modules of a session in such a state are there, or are on their way. */
export function isLive(life: SessionLife): boolean {
  return life === 'starting' || life === 'running' || life === 'degraded' || life === 'paused';
}

const WIRE_STATES: { readonly [S in SessionLife]: SessionState } = {
  created: SessionState.SESSION_CREATED,
  starting: SessionState.SESSION_STARTING,
  running: SessionState.SESSION_RUNNING,
  degraded: SessionState.SESSION_DEGRADED,
  paused: SessionState.SESSION_PAUSED,
  stopping: SessionState.SESSION_STOPPING,
  stopped: SessionState.SESSION_STOPPED,
};

/** The state as the protocol knows it. */
export function wireState(life: SessionLife): SessionState {
  return WIRE_STATES[life];
}

/** The coarser status that existing clients know [SE-10]. */
export function wireStatus(life: SessionLife): SessionStatus {
  if (life === 'created' || life === 'starting') return SessionStatus.CREATED;
  if (life === 'paused') return SessionStatus.PAUSED;
  return life === 'stopped' ? SessionStatus.STOPPED : SessionStatus.RUNNING;
}
