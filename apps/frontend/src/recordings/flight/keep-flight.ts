import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import { ServiceError, type Recording } from '@ubii/proto';
import type { Toasts } from '../../ui/toasts/toasts.ts';
import KeptToast from './KeptToast.vue';

/** What keeping takes. */
export interface KeepPorts {
  readonly client: Pick<UbiiClient, 'call' | 'id'>;
  readonly toasts: Pick<Toasts, 'show' | 'showBody'>;
}

/** Keeps the last minutes as a recording, and offers its name to be edited. @returns undefined when that failed */
export async function keepFlight({ client, toasts }: KeepPorts): Promise<Recording | undefined> {
  try {
    const recording = await client.call('flightRecorderKeep', { clientId: client.id });
    toasts.showBody(KeptToast, { recording });
    return recording;
  } catch (cause) {
    if (!(cause instanceof ServiceError || cause instanceof ConnectionError)) throw cause;
    toasts.show(`Nothing was kept. ${cause.message}`);
    return undefined;
  }
}
