import type { ConnectionErrorReason, ConnectionState } from '@ubii/client-web';
import type { MarkedState } from '../ui/UiStateMark.vue';

/** The connection's state as a mark and a word. */
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

/** What the strip under the top bar says: what was lost, what is retried and when, what can be done. */
export interface ConnectionNotice {
  readonly tone: 'warning' | 'error' | 'stopped';
  readonly text: string;
  /** What is being tried, and when; drawn dimmer. */
  readonly next: string | undefined;
  /** The button's words. */
  readonly action: string;
}

const CAUSES: Record<ConnectionErrorReason, string> = {
  closed: 'The master closed the connection',
  refused: 'The master cannot be reached',
  timeout: 'The master does not answer',
  protocol: 'The master sent data that this page cannot read',
  superseded: 'Another tab uses this identity',
  disconnected: 'This page was disconnected',
  join: 'This device has not joined',
};

/**
 * The notice for a state, or `undefined` while all is well or still starting.
 * @param nowMs this machine's clock, epoch milliseconds
 * @param hadData true once something was on the screen that now stands still
 */
export function connectionNotice(
  state: ConnectionState,
  nowMs: number,
  hadData: boolean,
): ConnectionNotice | undefined {
  switch (state.status) {
    case 'idle':
    case 'connecting':
    case 'connected':
      return undefined;
    case 'reconnecting': {
      const seconds = Math.ceil((state.nextAttemptMs - nowMs) / 1000);
      const tries = `try ${state.attempt}`;
      // It was closed once; how a later attempt fails depends on how far it got
      const isTriedAgain = state.attempt > 1 && state.error.reason === 'closed';
      const cause = CAUSES[isTriedAgain ? 'refused' : state.error.reason];
      return {
        tone: 'warning',
        text: `${cause}.${hadData ? ' The page shows the last values that it received.' : ''}`,
        next: seconds > 0 ? `Retry in ${seconds} s, ${tries}` : `Retrying, ${tries}`,
        action: 'Retry now',
      };
    }
    case 'closed':
      if (state.error === undefined) {
        return {
          tone: 'stopped',
          text: 'This page is disconnected from the master.',
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
      // The page for it says the rest.
      if (state.error.reason === 'join') return undefined;
      return {
        tone: 'error',
        text: `${CAUSES[state.error.reason]}. It does not reconnect automatically.`,
        next: state.error.message,
        action: 'Connect',
      };
  }
}
