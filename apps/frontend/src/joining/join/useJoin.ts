import { clientRole, ConnectionError, joinProblem } from '@ubii/client-web';
import type { Mark } from '@ubii/proto';
import { computed, onScopeDispose, shallowRef, watch } from 'vue';
import { useRoute, useRouter } from 'vue-router';
import { tryRequest } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { rememberStart, startPath } from '../../install/start-path.ts';
import { ANOTHER } from '../../locations/join-location.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';
import { checkToken } from './check-token.ts';
import {
  OPENED,
  type Check,
  type JoinEffect,
  type JoinEvent,
  type Situation,
} from './join-state.ts';
import { joinStep } from './join-step.ts';
import { replaceWithMark } from './move-mark.ts';
import { offeredMarks } from './offered-marks.ts';
import { safeTarget } from './target.ts';
import { isThisMachine } from './this-machine.ts';

/** Time after which a missing WebSocket is reported, milliseconds. */
const PATIENCE_MS = 10_000;

/** Who joins. */
export interface Joining {
  /** Display name; empty keeps the one before. */
  readonly name: string;
  readonly mark: Mark;
}

/** Performs joining, from a token or code to the target page, by executing `joinStep`. */
export function useJoin(beforeLeaving: () => void) {
  const { client, state: connection, isConnected, name, mark, connect } = useConnection();
  const route = useRoute();
  const router = useRouter();
  const toasts = useToasts();

  const state = shallowRef(OPENED);
  let timer: ReturnType<typeof setTimeout> | undefined;

  const target = computed(() => {
    const { invitation } = state.value;
    const named = invitation?.target || route.query['to'];
    const role = invitation?.role;
    // Admins go to the start page, also on a phone.
    return safeTarget(named || (role === 'admin' ? '/' : startPath(role !== 'viewer')));
  });

  function situation(): Situation {
    const { value } = connection;
    return {
      token: route.hash.slice(1),
      wantsAnother: ANOTHER in route.query,
      isThisMachine: isThisMachine(),
      connection: isConnected.value
        ? 'connected'
        : value.status === 'reconnecting' || value.status === 'closed'
          ? value.status
          : 'other',
      refusal: value.status === 'closed' ? value.error?.joinProblem : undefined,
      role: client.role,
    };
  }

  function dispatch(event: JoinEvent): void {
    const step = joinStep(state.value, event, situation());
    state.value = step.state;
    step.effects.forEach(perform);
  }

  function perform(effect: JoinEffect): void {
    switch (effect.type) {
      case 'check':
        return void check(effect.check);
      case 'join':
        return void settle(Promise.race([client.join(effect.token), patience()]));
      case 'reconnect':
        connect();
        return void settle(patience());
      case 'later':
        timer = setTimeout(() => dispatch(effect.event), effect.afterMs);
        return;
      case 'forget-later':
        return clearTimeout(timer);
      case 'leave':
        return leave(effect.becameAdmin);
    }
  }

  async function check(question: Check): Promise<void> {
    const { token, asClient } = question;
    const answer = await tryRequest(
      () => (asClient ? client.call('joinCheck', { token }) : checkToken(token)),
      ({ message }) => dispatch({ type: 'unanswered', check: question, message }),
    );
    if (answer === undefined) return;
    const { masterName, target, isJoined } = answer;
    const role = clientRole(answer.role);
    const problem = joinProblem(answer.problem);
    dispatch({
      type: 'checked',
      check: question,
      reply: { masterName, role, problem, target, isJoined, marks: offeredMarks(answer) },
    });
  }

  async function settle(joining: Promise<unknown>): Promise<void> {
    try {
      await joining;
      dispatch({ type: 'joined' });
    } catch (cause) {
      if (cause instanceof ConnectionError && cause.reason === 'join')
        dispatch({ type: 'refused', problem: cause.joinProblem });
      else if (cause instanceof Error) dispatch({ type: 'failed', message: cause.message });
      else throw cause;
    }
  }

  /** Rejects when the WebSocket takes too long; `client` continues to retry. */
  function patience(): Promise<never> {
    return new Promise((_, reject) => {
      setTimeout(() => {
        if (isConnected.value) return;
        const { value } = connection;
        const cause = value.status === 'reconnecting' ? `: ${value.error.message}` : '';
        reject(new ConnectionError('timeout', `The live connection does not open${cause}`));
      }, PATIENCE_MS);
    });
  }

  function leave(becameAdmin: boolean): void {
    beforeLeaving();
    if (state.value.invitation?.target) rememberStart(target.value);
    if (becameAdmin) toasts.show('This browser may do everything now');
    // Replaces this page in the history, so that Back does not return to the token.
    void replaceWithMark(router, target.value);
  }

  // A scanned URL may open in the same tab.
  watch(
    () => route.hash.slice(1),
    (token) => dispatch({ type: 'check', token }),
    { immediate: true },
  );
  watch([isConnected, connection], () => dispatch({ type: 'connection' }));
  onScopeDispose(() => clearTimeout(timer));

  return {
    state,
    target,
    isConnected,
    check: (token: string) => dispatch({ type: 'check', token }),
    join(as: Joining) {
      if (as.name.trim() !== '') name.value = as.name.trim();
      mark.set(as.mark);
      dispatch({ type: 'join' });
    },
    leave: () => dispatch({ type: 'leave' }),
  };
}
