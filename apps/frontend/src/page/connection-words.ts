import type { ConnectionErrorReason, ConnectionState } from '@ubii/client-web';
import type { MarkedState } from '../ui/UiStateMark.vue';

/** Round trip from which the way to the master is called slow, milliseconds: what one does is seen late. */
export const SLOW_MS = 100;

/** State of the connection as a mark and a word. */
export function connectionWord(state: ConnectionState): { mark: MarkedState; text: string } {
  switch (state.status) {
    case 'idle':
    case 'connecting':
      return { mark: 'away', text: 'Connecting' };
    case 'connected':
      return { mark: 'live', text: 'Connected' };
    case 'reconnecting':
      return { mark: 'warning', text: 'Reconnecting' };
    case 'closed':
      return state.error?.reason === 'superseded'
        ? { mark: 'stopped', text: 'In use elsewhere' }
        : state.error?.reason === 'disconnected'
          ? { mark: 'stopped', text: 'Disconnected' }
          : state.error?.reason === 'join'
            ? { mark: 'stopped', text: 'Not joined' }
            : { mark: 'error', text: 'Not connected' };
  }
}

/** Texts of the connection strip: what was lost, when it is retried, and what the user can do. */
export interface ConnectionNotice {
  readonly tone: 'warning' | 'error' | 'stopped';
  readonly text: string;
  /** Next attempt and its time, dimmed. */
  readonly next: string | undefined;
  /** Label of the button. */
  readonly action: string;
}

const CAUSES: Record<ConnectionErrorReason, string> = {
  closed: 'The connection was closed',
  refused: 'Ubi-Interact cannot be reached',
  timeout: 'Ubi-Interact does not answer',
  protocol: 'Ubi-Interact sent data that this page cannot read',
  superseded: 'Another tab uses this identity',
  disconnected: 'This page was disconnected',
  join: 'This device has not joined',
};

/**
 * Returns the notice for a state; `undefined` while connected or starting.
 * @param nowMs this computer's clock, epoch milliseconds
 * @param hadData true when live data was shown, which is now frozen
 * @param otherMasters addresses of the other masters of the cluster
 */
export function connectionNotice(
  state: ConnectionState,
  nowMs: number,
  hadData: boolean,
  otherMasters: readonly string[] = [],
): ConnectionNotice | undefined {
  switch (state.status) {
    case 'idle':
    case 'connecting':
    case 'connected':
      return undefined;
    case 'reconnecting': {
      const seconds = Math.ceil((state.nextAttemptMs - nowMs) / 1000);
      const tries = `try ${state.attempt}`;
      // An open connection closes only once: a later attempt that ends with `closed` was refused.
      const isTriedAgain = state.attempt > 1 && state.error.reason === 'closed';
      const cause = CAUSES[isTriedAgain ? 'refused' : state.error.reason];
      return {
        tone: 'warning',
        text: `${cause}.${othersWords(state.attempt, otherMasters)}${hadData ? ' The page shows the last values that it received.' : ''}`,
        next: seconds > 0 ? `Retry in ${seconds} s, ${tries}` : `Retrying, ${tries}`,
        action: 'Retry now',
      };
    }
    case 'closed':
      if (state.error === undefined) {
        return {
          tone: 'stopped',
          text: 'This page is disconnected.',
          next: undefined,
          action: 'Connect',
        };
      }
      if (state.error.reason === 'superseded') {
        return {
          tone: 'stopped',
          text: `${CAUSES.superseded}. This tab is disconnected.`,
          next: undefined,
          action: 'Use this tab',
        };
      }
      if (state.error.reason === 'disconnected') {
        return {
          tone: 'stopped',
          text: state.error.message.replace('This client', 'This page'),
          next: undefined,
          action: 'Connect',
        };
      }
      // The join page explains the rest.
      if (state.error.reason === 'join') return undefined;
      return {
        tone: 'error',
        text: `${CAUSES[state.error.reason]}. It does not reconnect automatically.`,
        next: state.error.message,
        action: 'Connect',
      };
  }
}

/** Attempts after which the other masters have been asked as well. */
const ATTEMPTS_BEFORE_OTHERS = 8;

/** A browser does not tell a missing master from one whose certificate it does not trust. */
function othersWords(tries: number, otherMasters: readonly string[]): string {
  if (otherMasters.length === 0 || tries < ATTEMPTS_BEFORE_OTHERS) return '';
  const words = ' The other computers of the cluster cannot be reached either.';
  return otherMasters.some((url) => url.startsWith('https:'))
    ? `${words} Over HTTPS, this device has to trust the certificate of each computer.`
    : words;
}
