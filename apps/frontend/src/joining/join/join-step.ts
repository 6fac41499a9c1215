import type {
  Check,
  CheckReply,
  JoinEffect,
  JoinEvent,
  JoinState,
  Situation,
} from './join-state.ts';

/** Delay before an unreachable master is asked again, milliseconds. */
const ASK_AGAIN_MS = 3000;
/** Delay before a code is sent again while others try wrong codes, milliseconds. [AC-17] */
const GUESSING_AGAIN_MS = 1000;

const GUESSING = 'Too many wrong codes from this network. This page keeps retrying.';

/** The next state, and the actions to perform. */
export interface JoinStep {
  readonly state: JoinState;
  readonly effects: readonly JoinEffect[];
}

/** Returns the step for an event. A page that is being left ignores all events. */
export function joinStep(state: JoinState, event: JoinEvent, situation: Situation): JoinStep {
  if (state.isLeaving) return { state, effects: [] };
  const first = handleEvent(state, event, situation);
  const second = continueConnected(first.state, situation);
  return { state: second.state, effects: [...first.effects, ...second.effects] };
}

function handleEvent(state: JoinState, event: JoinEvent, situation: Situation): JoinStep {
  switch (event.type) {
    case 'check':
      return beginCheck(state, event.token, situation);
    case 'checked':
      return event.check.number === state.checks
        ? handleReply(state, event.check, event.reply, situation)
        : stay(state);
    case 'unanswered':
      return event.check.number === state.checks
        ? handleSilence(state, event.check.token, event.message)
        : stay(state);
    case 'join':
      return state.phase === 'joining' ? stay(state) : beginJoin(state, situation);
    case 'join-again':
      return beginJoin(state, situation);
    case 'joined':
      return situation.connection === 'connected' ? leave(state, situation) : stay(state);
    case 'refused':
      return state.phase === 'joining' ? handleRefusal(state, event.problem) : stay(state);
    case 'failed':
      return stay(
        state.phase === 'joining' ? { ...state, phase: 'ready', trouble: event.message } : state,
      );
    case 'connection':
      return stay(
        situation.token === '' && ['asking', 'code'].includes(state.phase)
          ? withoutToken(state, situation)
          : state,
      );
    case 'leave':
      return leave(state, situation);
  }
}

/**
 * A connected client continues: a second tab, the master’s own computer, or a late WebSocket. A code of another
 * invitation is used for joining, whatever its role: it may permit other topics. [AC-18]
 */
function continueConnected(state: JoinState, situation: Situation): JoinStep {
  const { invitation, phase } = state;
  if (situation.connection !== 'connected' || state.isLeaving) return stay(state);
  const isPlain = situation.token === '' && !situation.wantsAnother;
  const hasJoined = invitation?.isJoined === true || (phase === 'joining' && !state.wasConnected);
  const isAdmin = invitation !== undefined && situation.role === 'admin';
  if ((invitation === undefined && isPlain) || hasJoined || isAdmin) return leave(state, situation);
  // The operator on the master’s own computer has a name and need not confirm. [AC-42]
  const joinsByItself = situation.isThisMachine && invitation?.role === 'admin';
  if (phase === 'ready' && joinsByItself && state.trouble === '')
    return beginJoin(state, situation);
  const mayHaveJoined = phase === 'ready' || (phase === 'code' && state.problem === 'used');
  if (mayHaveJoined && !state.isToClient) return beginCheck(state, situation.token, situation);
  return stay(state);
}

function beginCheck(state: JoinState, token: string, situation: Situation): JoinStep {
  const isWaiting = state.phase === 'code' && state.problem === 'guessing';
  const number = state.checks + 1;
  const asClient = situation.connection === 'connected';
  return {
    state: {
      ...state,
      checks: number,
      phase: state.phase === 'unreachable' || isWaiting ? state.phase : 'asking',
      trouble: '',
    },
    effects: [{ type: 'forget-later' }, { type: 'check', check: { number, token, asClient } }],
  };
}

function handleReply(
  state: JoinState,
  { token, asClient }: Check,
  { masterName, role, problem, target, isJoined, marks }: CheckReply,
  situation: Situation,
): JoinStep {
  const known = { ...state, isToClient: asClient, masterName, problem };
  if (token !== '' && role !== undefined && problem === undefined) {
    return stay({ ...known, phase: 'ready', invitation: { token, role, target, isJoined, marks } });
  }
  const without = { ...known, invitation: undefined };
  return {
    state: token === '' ? withoutToken(without, situation) : { ...without, phase: 'code' },
    effects: problem === 'guessing' ? [later(GUESSING_AGAIN_MS, { type: 'check', token })] : [],
  };
}

function handleSilence(state: JoinState, token: string, message: string): JoinStep {
  return {
    state: { ...state, phase: 'unreachable', trouble: message },
    effects: [later(ASK_AGAIN_MS, { type: 'check', token })],
  };
}

/** Without a token in the URL: shows why this device was sent here, once that is known. */
function withoutToken(
  state: JoinState,
  { connection, wantsAnother, refusal }: Situation,
): JoinState {
  if (connection !== 'closed' && !wantsAnother) return state;
  return { ...state, phase: 'code', problem: refusal ?? 'missing' };
}

function beginJoin(state: JoinState, { connection, role }: Situation): JoinStep {
  const { invitation, trouble } = state;
  if (invitation === undefined) return stay(state);
  // A token for one device works once; a registered client only waits for its WebSocket.
  const isRegistered = role !== undefined && connection === 'reconnecting';
  return {
    state: {
      ...state,
      phase: 'joining',
      trouble: trouble === GUESSING ? trouble : '',
      wasConnected: connection === 'connected',
    },
    effects: [isRegistered ? { type: 'reconnect' } : { type: 'join', token: invitation.token }],
  };
}

function handleRefusal(state: JoinState, problem: JoinState['problem']): JoinStep {
  if (problem === 'guessing') {
    return {
      state: { ...state, trouble: GUESSING },
      effects: [later(GUESSING_AGAIN_MS, { type: 'join-again' })],
    };
  }
  return stay({ ...state, phase: 'code', problem: problem ?? 'wrong', invitation: undefined });
}

function leave(state: JoinState, { wantsAnother, role }: Situation): JoinStep {
  const becameAdmin = state.invitation !== undefined && wantsAnother && role === 'admin';
  return { state: { ...state, isLeaving: true }, effects: [{ type: 'leave', becameAdmin }] };
}

function later(afterMs: number, event: JoinEvent): JoinEffect {
  return { type: 'later', afterMs, event };
}

function stay(state: JoinState): JoinStep {
  return { state, effects: [] };
}
