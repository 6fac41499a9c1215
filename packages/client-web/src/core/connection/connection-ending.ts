import { ConnectionError } from './connection-error.ts';
import type {
  ConnectionMemory,
  Farewell,
  MachineContext,
  MachineEffect,
  MachineState,
  Outage,
  Step,
} from './connection-model.ts';
import { BROKEN, isAnswered, isTold, remedyFor } from './link-failure.ts';
import type { LinkFailure, Remedy } from './link-failure.ts';
import { reconnectDelayMs } from './reconnect-policy.ts';

/** A state with an attempt under way, or with the link that came of it. */
export type LiveState = Exclude<MachineState, { phase: 'idle' | 'waiting' | 'closed' }>;

/** The program closes the client. */
export function close(state: MachineState, farewell: Farewell): Step {
  const effects = [
    ...endPhase(state),
    // A link that is up is left to the caller, who may have something to say.
    ...(state.phase === 'connected' ? [] : closeLink(state, farewell)),
  ];
  return stop(state.memory, effects, undefined);
}

/**
 * The attempt or the link failed: another attempt follows, unless it cannot succeed.
 * @param mustHurry whether it follows without delay
 */
export function fail(
  state: LiveState,
  failure: LinkFailure,
  context: MachineContext,
  mustHurry = false,
): Step {
  if (state.memory.hasSwitched) return failVisit(state, failure, context);
  const remedy = remedyFor(failure);
  const effects: readonly MachineEffect[] = [
    ...endPhase(state),
    ...closeLink(state, {}),
    ...toRegistration(state, failure, remedy, context),
  ];
  // The master replied with what to do: do that without a delay once in an outage.
  const hurries = mustHurry || (isTold(failure) && !state.memory.hasHurried);
  const failedAttempts = hurries ? state.memory.failedAttempts : countFailure(state, context);
  const memory = {
    ...state.memory,
    failedAttempts,
    hasHurried: hurries || state.memory.hasHurried,
    wasSilent: (failure.wasUp && failure.error.reason === 'timeout') || state.memory.wasSilent,
    outage: outageOf(state, failure, context),
  };
  const delayMs = reconnectDelayMs(
    context.policy,
    failedAttempts,
    () => context.chance,
    isAnswered(failure),
  );
  if (remedy === 'stop' || delayMs === undefined) return stop(memory, effects, failure.error);
  return wait(state, memory, effects, { failure, delayMs: hurries ? 0 : delayMs, context });
}

/** Whatever another master says, the client still has its own. [CU-83] */
function failVisit(state: LiveState, failure: LinkFailure, context: MachineContext): Step {
  const memory = { ...state.memory, hasSwitched: false };
  const effects: readonly MachineEffect[] = [
    ...endPhase(state),
    ...closeLink(state, {}),
    { type: 'switch-back' },
  ];
  const { policy, chance } = context;
  const delayMs =
    reconnectDelayMs(policy, memory.failedAttempts, () => chance, false) ??
    policy.maxUnansweredDelayMs;
  return wait(state, memory, effects, { failure, delayMs, context });
}

/** Waits for the next attempt at the own master. */
function wait(
  state: LiveState,
  memory: ConnectionMemory,
  effects: readonly MachineEffect[],
  { failure, delayMs, context }: { failure: LinkFailure; delayMs: number; context: MachineContext },
): Step {
  const announced = {
    status: 'reconnecting',
    attempt: state.phase === 'connected' ? 1 : state.announced.attempt + 1,
    nextAttemptMs: context.nowMs + delayMs,
    error: failure.error,
  } as const;
  return {
    state: { phase: 'waiting', announced, memory },
    effects: [...effects, { type: 'start-retry', delayMs }, { type: 'announce', state: announced }],
  };
}

/** A link that ends is the beginning; an attempt that is answered, even by a refusal, the end. [CU-81] */
function outageOf(
  state: LiveState,
  failure: LinkFailure,
  { monotonicMs }: MachineContext,
): Outage | undefined {
  if (state.phase === 'connected') return { sinceMs: monotonicMs, failedStartMs: undefined };
  if (isAnswered(failure)) return undefined;
  const sinceMs = state.memory.outage?.sinceMs ?? monotonicMs;
  return { sinceMs, failedStartMs: state.startedMs };
}

function countFailure(state: LiveState, { monotonicMs, policy }: MachineContext): number {
  const hasHeld =
    state.phase === 'connected' && monotonicMs - state.connectedMs >= policy.stableAfterMs;
  return hasHeld ? 0 : state.memory.failedAttempts + 1;
}

/** Converts a failure to its meaning for the registration. */
function toRegistration(
  state: LiveState,
  failure: LinkFailure,
  remedy: Remedy,
  { hasCredential }: MachineContext,
): readonly MachineEffect[] {
  const { reason, cause } = failure.error;
  switch (remedy) {
    case 'stop': {
      // Not ours any more, so `close()` must not deregister it; `connect()` may take it back.
      const isLost = reason === 'superseded' || reason === 'disconnected' || reason === 'join';
      return isLost ? [{ type: 'invalidate' }] : [];
    }
    case 'register-as-new':
      return [{ type: 'forget' }];
    case 'register-again':
      return [{ type: isTold(failure) ? 'invalidate' : 'distrust' }];
    case 'retry': {
      // A socket that is refused silently: services say why, and a browser is not told. [AC-27]
      const isMute = failure.code === BROKEN && !failure.wasUp && cause === undefined;
      return hasLink(state) && isMute && hasCredential ? [{ type: 'distrust' }] : [];
    }
  }
}

function stop(
  memory: ConnectionMemory,
  effects: readonly MachineEffect[],
  error: ConnectionError | undefined,
): Step {
  const announced = { status: 'closed', error } as const;
  return {
    state: { phase: 'closed', announced, memory },
    effects: [
      ...effects,
      {
        type: 'settle',
        error: error ?? new ConnectionError('closed', 'The client was closed'),
      },
      { type: 'announce', state: announced },
    ],
  };
}

/** Ends the timers of a phase. */
function endPhase({ phase }: MachineState): readonly MachineEffect[] {
  switch (phase) {
    case 'idle':
    case 'closed':
      return [];
    case 'waiting':
      return [{ type: 'cancel-retry' }];
    case 'connected':
      return [{ type: 'stop-sleep-watch' }];
    default:
      return [{ type: 'cancel-attempt-timer' }];
  }
}

function closeLink(state: MachineState, farewell: Farewell): readonly MachineEffect[] {
  return hasLink(state) ? [{ type: 'close-link', farewell }] : [];
}

function hasLink({ phase }: MachineState): boolean {
  return ['opening', 'checking', 'restoring', 'connected'].includes(phase);
}

/** Whether an attempt is under way, or its link is in use. */
export function isLive(state: MachineState): state is LiveState {
  return state.phase === 'registering' || hasLink(state);
}
