import { clientRole, ConnectionError, joinProblem } from '@ubii/client-web';
import type { ClientRole, JoinProblem } from '@ubii/client-web';
import { ServiceError } from '@ubii/proto';
import { computed, onScopeDispose, ref, shallowRef, watch } from 'vue';
import { useRoute, useRouter } from 'vue-router';
import { useConnection } from '../../connection/useConnection.ts';
import { rememberStart, startPath } from '../../install/start-path.ts';
import { ANOTHER } from '../../locations/join-location.ts';
import { useToasts } from '../../ui/toasts/toasts.ts';
import { checkToken } from './check-token.ts';
import { safeTarget } from './target.ts';
import { isThisMachine } from './this-machine.ts';

/**
 * `asking`: checks the token · `code`: the user has to type a code · `ready`: one tap away ·
 * `joining` · `unreachable`: no answer
 */
export type JoinPhase = 'asking' | 'code' | 'ready' | 'joining' | 'unreachable';

/** What a good token gives. */
export interface Invitation {
  readonly token: string;
  readonly role: ClientRole;
  /** Path of the page that opens; empty when the token names none. */
  readonly target: string;
  /** This client has joined with it: there is nothing to be asked. */
  readonly isJoined: boolean;
}

/** A master that does not answer is asked again after this, milliseconds. */
const ASK_AGAIN_MS = 3000;
/** While others try wrong codes, a code is shown again after this, milliseconds. [AC-17] */
const GUESSING_AGAIN_MS = 1000;
/** A live channel that takes longer is a trouble to be told, milliseconds. */
const PATIENCE_MS = 10_000;

const GUESSING = 'Too many wrong codes from this network. This page keeps retrying.';

/** The way of one device from a token or code to the page it came for. */
export function useJoin(beforeLeaving: () => void) {
  const { client, state, isConnected, name, connect } = useConnection();
  const route = useRoute();
  const router = useRouter();
  const toasts = useToasts();

  const phase = ref<JoinPhase>('asking');
  const problem = shallowRef<JoinProblem>();
  /** Error of joining, as reported by the master or the browser. */
  const trouble = ref('');
  const invitation = shallowRef<Invitation>();
  const masterName = ref('');
  const isLeaving = ref(false);
  let again: ReturnType<typeof setTimeout> | undefined;
  let asked = 0;
  /** True when the last reply was about this client, not about the token. */
  let isToClient = false;
  /** It was in already when it began to join: with another code. */
  let wasIn = false;

  const target = computed(() => {
    const named = invitation.value?.target || route.query['to'];
    const role = invitation.value?.role;
    // An admin runs the place, also from a phone.
    return safeTarget(named || (role === 'admin' ? '/' : startPath(role !== 'viewer')));
  });

  function goOn(): void {
    if (isLeaving.value) return;
    isLeaving.value = true;
    beforeLeaving();
    if (invitation.value?.target) rememberStart(target.value);
    if (invitation.value !== undefined && wantsAnother() && client.role === 'admin')
      toasts.show('This browser is now an admin');
    // In place of this page: the way back does not lead through the token
    void router.replace(target.value);
  }

  /** Asks what a token or code is good for; without one, what this device may do. */
  async function ask(token: string): Promise<void> {
    clearTimeout(again);
    asked += 1;
    const serial = asked;
    const asClient = isConnected.value;
    const isWaiting = phase.value === 'code' && problem.value === 'guessing';
    if (phase.value !== 'unreachable' && !isWaiting) phase.value = 'asking';
    trouble.value = '';
    try {
      const answer = await (asClient ? client.call('joinCheck', { token }) : checkToken(token));
      if (serial !== asked) return;
      isToClient = asClient;
      masterName.value = answer.masterName;
      const role = clientRole(answer.role);
      problem.value = joinProblem(answer.problem);
      if (token !== '' && role !== undefined && problem.value === undefined) {
        const { target: opens, isJoined } = answer;
        invitation.value = { token, role, target: opens, isJoined };
        phase.value = 'ready';
      } else {
        invitation.value = undefined;
        if (token === '') handleMissingToken();
        else phase.value = 'code';
        if (problem.value === 'guessing')
          again = setTimeout(() => void ask(token), GUESSING_AGAIN_MS);
      }
    } catch (cause) {
      if (serial !== asked) return;
      if (!(cause instanceof ConnectionError || cause instanceof ServiceError)) throw cause;
      trouble.value = cause.message;
      phase.value = 'unreachable';
      again = setTimeout(() => void ask(token), ASK_AGAIN_MS);
    }
  }

  /** Nothing was shown: says why this device was sent here, once that is known. */
  function handleMissingToken(): void {
    const isRefused = state.value.status === 'closed';
    if (!isRefused && !wantsAnother()) return;
    problem.value = refusal() ?? 'missing';
    phase.value = 'code';
  }

  /** A client that may have joined already opened the page to enter a code. */
  const wantsAnother = (): boolean => ANOTHER in route.query;

  function refusal(): JoinProblem | undefined {
    return state.value.status === 'closed' ? state.value.error?.joinProblem : undefined;
  }

  /** @param as what others are to call this device */
  async function join(as: string): Promise<void> {
    const token = invitation.value?.token;
    if (token === undefined || phase.value === 'joining') return;
    if (as.trim() !== '') name.value = as.trim();
    wasIn = isConnected.value;
    phase.value = 'joining';
    if (trouble.value !== GUESSING) trouble.value = '';
    const isRegistered = client.role !== undefined && state.value.status === 'reconnecting';
    try {
      // A token for one device counts once; who is registered only waits for the channel
      if (isRegistered) connect();
      else await Promise.race([client.join(token), patience()]);
      if (isConnected.value) goOn();
      else if (isRegistered) await patience();
    } catch (cause) {
      if (cause instanceof ConnectionError && cause.reason === 'join') {
        if (cause.joinProblem === 'guessing') {
          trouble.value = GUESSING;
          again = setTimeout(() => {
            phase.value = 'ready';
            void join(as);
          }, GUESSING_AGAIN_MS);
          return;
        }
        problem.value = cause.joinProblem ?? 'wrong';
        invitation.value = undefined;
        phase.value = 'code';
        return;
      }
      if (!(cause instanceof Error)) throw cause;
      trouble.value = cause.message;
      phase.value = 'ready';
    }
  }

  /** Rejects when the channel takes too long; `client` goes on trying meanwhile. */
  function patience(): Promise<never> {
    return new Promise((_, reject) => {
      setTimeout(() => {
        if (isConnected.value) return;
        const { value } = state;
        const cause = value.status === 'reconnecting' ? `: ${value.error.message}` : '';
        reject(new ConnectionError('timeout', `The live connection does not open${cause}`));
      }, PATIENCE_MS);
    });
  }

  /** The operator at the master's own machine has a name and is in: there is nothing to be asked. [AC-42] */
  const makesAdminHere = (): boolean => isThisMachine() && invitation.value?.role === 'admin';

  // A scanned address opens in the same tab as well
  watch(
    () => route.hash.slice(1),
    (token) => {
      if (!isLeaving.value) void ask(token);
    },
    { immediate: true },
  );

  // Who is in already goes on: a second tab, the master's own machine, or a channel that came late.
  // A code of another grant is joined with, whatever its role: it brings topics of its own. [AC-18]
  watch(
    [isConnected, phase],
    () => {
      if (!isConnected.value) return;
      const isJoining = phase.value === 'joining';
      const mayBeIn =
        phase.value === 'ready' || (phase.value === 'code' && problem.value === 'used');
      const isPlain = route.hash === '' && !wantsAnother();
      if (invitation.value === undefined && isPlain) goOn();
      else if (invitation.value?.isJoined === true || (isJoining && !wasIn)) goOn();
      else if (invitation.value !== undefined && client.role === 'admin') goOn();
      else if (phase.value === 'ready' && makesAdminHere()) void join(name.value);
      else if (mayBeIn && !isToClient) void ask(route.hash.slice(1));
    },
    { immediate: true },
  );
  watch(state, () => {
    if (route.hash === '' && ['asking', 'code'].includes(phase.value)) handleMissingToken();
  });
  onScopeDispose(() => clearTimeout(again));

  return {
    phase,
    problem,
    trouble,
    invitation,
    masterName,
    target,
    isIn: computed(() => isConnected.value),
    ask,
    join,
    goOn,
  };
}
