import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import { ServiceError } from '@ubii/proto';
import type { Toasts } from '../../ui/toasts/toasts.ts';
import MarkedToast from './MarkedToast.vue';

/** What marking takes. */
export interface MarkPorts {
  readonly client: Pick<UbiiClient, 'call' | 'id'>;
  readonly toasts: Pick<Toasts, 'show' | 'showBody'>;
}

/** Marks this moment in all that is being recorded, and offers the text of the marker to be edited. */
export async function markNow({ client, toasts }: MarkPorts): Promise<void> {
  try {
    const marker = await client.call('recordingMark', { clientId: client.id });
    toasts.showBody(MarkedToast, { marker });
  } catch (cause) {
    if (!(cause instanceof ServiceError || cause instanceof ConnectionError)) throw cause;
    toasts.show(`Not marked. ${cause.message}`);
  }
}
