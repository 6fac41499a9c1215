import type { UbiiClient } from '@ubii/client-web';
import { tryRequest } from '../../connection/useAttempt.ts';
import type { Toasts } from '../../ui/toasts/toasts.ts';
import MarkedToast from './MarkedToast.vue';

/** What marking takes. */
export interface MarkPorts {
  readonly client: Pick<UbiiClient, 'call' | 'id'>;
  readonly toasts: Pick<Toasts, 'show' | 'showBody'>;
}

/** Marks this moment in all that is being recorded, and offers the text of the marker to be edited. */
export async function markNow({ client, toasts }: MarkPorts): Promise<void> {
  const marker = await tryRequest(
    () => client.call('recordingMark', { clientId: client.id }),
    ({ message }) => toasts.show(`Not marked. ${message}`),
  );
  if (marker) toasts.showBody(MarkedToast, { marker });
}
