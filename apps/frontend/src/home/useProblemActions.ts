import { tryRequest } from '../connection/useAttempt.ts';
import { useConnection } from '../connection/useConnection.ts';
import { useShell } from '../page/shell.ts';
import { formatNumber } from '../ui/readouts/format-number.ts';
import { useToasts } from '../ui/toasts/toasts.ts';
import type { ProblemAction } from './home-problems.ts';

/** Returns half of a rate, rounded: the first throttle to try. */
export function halfRate(recordsPerSecond: number): number {
  const half = Math.max(1, recordsPerSecond / 2);
  const step = 10 ** Math.floor(Math.log10(half));
  return Math.floor(half / step) * step;
}

export const ACTION_WORDS: Readonly<Record<ProblemAction['kind'], string>> = {
  'show-qr': 'Show QR',
  throttle: 'Throttle',
  unthrottle: 'Remove throttle',
  'stop-session': 'Stop session',
};

/** Runs the action of a problem, reports it and offers to undo it. */
export function useProblemActions(): (action: ProblemAction) => Promise<void> {
  const { client, clients, sessions, reports } = useConnection();
  const shell = useShell();
  const toasts = useToasts();
  const nameOf = (id: string): string => clients.find(id)?.name || 'The client';

  async function throttle(targetId: string, recordsPerSecond: number): Promise<void> {
    const reason =
      recordsPerSecond === 0 ? '' : 'This client takes too large a share of the forwarding work.';
    await client.call('clientThrottle', { targetId, recordsPerSecond, reason });
    void reports.refresh();
  }

  async function run(action: ProblemAction): Promise<void> {
    switch (action.kind) {
      case 'show-qr':
        return shell.open('connect-phone');
      case 'throttle': {
        const { clientId } = action;
        await reports.refresh();
        const rate = halfRate(reports.byId.value?.get(clientId)?.recordsInPerSecond ?? 0);
        await throttle(clientId, rate);
        return toasts.show(
          `Throttled ${nameOf(clientId)} to ${formatNumber(rate)} records per second.`,
          {
            text: 'Undo',
            run: () => void request(() => throttle(clientId, 0)),
          },
        );
      }
      case 'unthrottle':
        await throttle(action.clientId, 0);
        return toasts.show(`Throttle removed from ${nameOf(action.clientId)}.`);
      case 'stop-session': {
        const id = action.sessionId;
        await client.call('sessionRuntimeStop', { id });
        return toasts.show(`Stopped ${sessions.find(id)?.name || 'the session'}`, {
          text: 'Undo',
          run: () =>
            void request(async () => void (await client.call('sessionRuntimeStart', { id }))),
        });
      }
    }
  }

  const request = (work: () => Promise<void>): Promise<void> =>
    tryRequest(work, ({ message }) => toasts.show(message));

  return (action) => request(() => run(action));
}
