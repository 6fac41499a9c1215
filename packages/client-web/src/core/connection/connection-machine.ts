import { ConnectionError } from './connection-error.ts';
import { close, fail, isLive } from './connection-ending.ts';
import type { LiveState } from './connection-ending.ts';
import type {
  AttemptEvent,
  ConnectionMemory,
  MachineContext,
  MachineEffect,
  MachineEvent,
  MachineState,
  Step,
} from './connection-model.ts';
import { BROKEN } from './link-failure.ts';

type In<P extends MachineState['phase']> = Extract<MachineState, { phase: P }>;

/** An attempt younger than this is left alone by `retry-now`, milliseconds. */
const FRESH_ATTEMPT_MS = 1_000;

/**
 * Timeout of the first attempts to reconnect until the connection is established, milliseconds. Doubled after each
 * timeout: the network may be gone, or the computer busy. [CL-43]
 */
const FIRST_ATTEMPT_TIMEOUT_MS = 2_000;

/** The connection as a state machine: returns the next state, and what is to be done. Has no side effects. */
export function transition(
  state: MachineState,
  event: MachineEvent,
  context: MachineContext,
): Step {
  switch (event.type) {
    case 'connect':
      return state.phase === 'idle' || state.phase === 'closed'
        ? connect(state.memory, context)
        : stay(state);
    case 'retry-now':
      return retryNow(state, context);
    case 'retry-due':
      return state.phase === 'waiting'
        ? startAttempt(state.announced, state.memory, context)
        : stay(state);
    case 'recheck':
      return state.phase === 'waiting' ? recheck(state, context) : stay(state);
    case 'switch-master':
      return state.phase === 'waiting' ? switchMaster(state, event.url, context) : stay(state);
    case 'drop':
      return state.phase === 'connected'
        ? fail(state, { error: event.error, code: BROKEN, wasUp: true }, context)
        : stay(state);
    case 'close':
      return close(state, event.farewell);
    case 'identity-loaded':
      return stay(remember(state, { lastId: state.memory.lastId ?? event.clientId }));
    default:
      return isLive(state) && event.attempt === state.memory.attemptId
        ? advance(state, event, context)
        : stay(state);
  }
}

/** The steps of an attempt. An event that does not belong to the phase changes nothing. */
function advance(state: LiveState, event: AttemptEvent, context: MachineContext): Step {
  if (event.type === 'failed') return fail(state, event.failure, context);
  if (event.type === 'attempt-timeout')
    return failByTimeout(state, event.attemptTimeoutMs, context);
  const { attempt, type } = event;
  if (state.phase === 'registering' && type === 'registered') {
    const { membership, isAnswered } = event;
    return {
      state: { ...state, phase: 'opening', membership },
      effects: [
        // The master is busy: another request would lose the place of this one. [CL-43]
        ...(isAnswered ? [{ type: 'cancel-attempt-timer' } as const] : []),
        { type: 'open-link', attempt, membership },
      ],
    };
  }
  if (state.phase === 'opening' && type === 'link-up') return handleUp(state);
  if (state.phase === 'checking' && type === 'known') return restore(state);
  if (state.phase === 'restoring' && type === 'restored') return arrive(state, context);
  return stay(state);
}

function connect(memory: ConnectionMemory, context: MachineContext): Step {
  const announced = { status: 'connecting', attempt: 1 } as const;
  const fresh = { ...memory, failedAttempts: 0, hasHurried: false, hasSwitched: false };
  const { state, effects } = startAttempt(announced, fresh, context);
  return {
    state,
    effects: [
      ...(memory.hasSwitched ? [{ type: 'switch-back' } as const] : []), // it was closed there
      ...effects,
      { type: 'announce', state: announced },
    ],
  };
}

/** [CU-82] */
function recheck({ announced, memory }: In<'waiting'>, context: MachineContext): Step {
  const { state, effects } = startAttempt(announced, memory, context);
  return { state, effects: [{ type: 'cancel-retry' }, ...effects] };
}

/** [CU-83] */
function switchMaster(
  { announced, memory }: In<'waiting'>,
  url: string,
  context: MachineContext,
): Step {
  const { state, effects } = startAttempt(announced, { ...memory, hasSwitched: true }, context);
  return {
    state,
    effects: [{ type: 'cancel-retry' }, { type: 'switch-to-master', url }, ...effects],
  };
}

function startAttempt(
  announced: In<'registering'>['announced'],
  memory: ConnectionMemory,
  { monotonicMs, openTimeoutMs }: MachineContext,
): Step {
  const attempt = memory.attemptId + 1;
  const attemptTimeoutMs = FIRST_ATTEMPT_TIMEOUT_MS * 2 ** memory.slowAttempts;
  // Another master has just answered. It may be slow because many come at once, and not faster by their asking again.
  const isTimed =
    announced.status === 'reconnecting' && attemptTimeoutMs < openTimeoutMs && !memory.hasSwitched;
  return {
    state: {
      phase: 'registering',
      announced,
      startedMs: monotonicMs,
      memory: { ...memory, attemptId: attempt },
    },
    effects: [
      ...(isTimed ? [{ type: 'start-attempt-timer', attempt, attemptTimeoutMs } as const] : []),
      { type: 'register', attempt },
    ],
  };
}

function handleUp(opening: In<'opening'>): Step {
  const state = remember({ ...opening, phase: 'checking' }, { wasSilent: false });
  const effects: readonly MachineEffect[] = opening.memory.wasSilent
    ? [{ type: 'freshen-services' }]
    : [];
  // A master of ours closes the socket of a client that it does not know.
  const then = opening.membership.isExtended
    ? restore(state)
    : { state, effects: [{ type: 'check-known', attempt: state.memory.attemptId } as const] };
  return { state: then.state, effects: [...effects, ...then.effects] };
}

function restore(state: In<'checking'>): Step {
  const { membership, memory } = state;
  const arrival = { membership, previousId: memory.lastId ?? '' };
  return {
    state: { ...state, phase: 'restoring' },
    effects: [{ type: 'restore', attempt: memory.attemptId, arrival }],
  };
}

function arrive({ membership, memory }: In<'restoring'>, context: MachineContext): Step {
  const { clientId } = membership.identity;
  const announced = {
    status: 'connected',
    clientId,
    resumed: clientId === memory.lastId,
    masterVersion: membership.masterVersion,
    sinceMs: context.nowMs,
  } as const;
  return {
    state: {
      phase: 'connected',
      announced,
      connectedMs: context.monotonicMs,
      memory: {
        ...memory,
        lastId: clientId,
        slowAttempts: 0,
        hasHurried: false,
        outage: undefined,
        hasSwitched: false,
      },
    },
    effects: [
      { type: 'cancel-attempt-timer' },
      ...(memory.hasSwitched ? [{ type: 'confirm-switch' } as const] : []),
      { type: 'start-sleep-watch' },
      { type: 'settle', error: undefined },
      { type: 'announce', state: announced },
    ],
  };
}

/** [CL-41] */
function retryNow(before: MachineState, context: MachineContext): Step {
  const state = remember(before, { slowAttempts: 0 });
  if (state.phase === 'connected') return { state, effects: [{ type: 'probe-link' }] };
  if (state.phase === 'waiting') {
    const memory = { ...state.memory, failedAttempts: 0 };
    const started = startAttempt(state.announced, memory, context);
    return {
      state: started.state,
      effects: [{ type: 'cancel-retry' }, { type: 'trust' }, ...started.effects],
    };
  }
  if (!mayAbandon(state, context)) return stay(state);
  const ageMs = context.monotonicMs - state.startedMs;
  if (ageMs < FRESH_ATTEMPT_MS) return stay(state);
  const message = `The connection attempt was replaced by a new one after ${Math.round(ageMs)} ms`;
  return abandon(state, message, context, true);
}

function failByTimeout(before: LiveState, attemptTimeoutMs: number, context: MachineContext): Step {
  if (!mayAbandon(before, context)) return stay(before);
  const state = remember(before, { slowAttempts: before.memory.slowAttempts + 1 });
  return abandon(
    state,
    `Expected the master to answer within ${attemptTimeoutMs} ms`,
    context,
    false,
  );
}

/** Before the link is up nothing is lost, unless a second registration would make a second client. */
function mayAbandon(
  state: MachineState,
  { isResumable }: MachineContext,
): state is In<'registering'> | In<'opening'> {
  return state.phase === 'opening' || (state.phase === 'registering' && isResumable);
}

function abandon(
  state: LiveState,
  message: string,
  context: MachineContext,
  mustHurry: boolean,
): Step {
  const error = new ConnectionError('closed', message);
  const step = fail(state, { error, code: BROKEN, wasUp: false }, context, mustHurry);
  return {
    state: step.state,
    effects: [{ type: 'cancel-registration', error }, ...step.effects],
  };
}

function remember<S extends MachineState>(state: S, change: Partial<ConnectionMemory>): S {
  return { ...state, memory: { ...state.memory, ...change } };
}

function stay(state: MachineState): Step {
  return { state, effects: [] };
}
