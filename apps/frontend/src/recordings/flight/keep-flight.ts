import type { UbiiClient } from '@ubii/client-web';
import type { Recording } from '@ubii/proto';
import { tryRequest } from '../../connection/useAttempt.ts';
import type { Toasts } from '../../ui/toasts/toasts.ts';
import KeptToast from './KeptToast.vue';

/** What keeping takes. */
export interface KeepPorts {
  readonly client: Pick<UbiiClient, 'call' | 'id'>;
  readonly toasts: Pick<Toasts, 'show' | 'showBody'>;
}

/** Keeps the last minutes as a recording, and offers its name to be edited. @returns undefined when that failed */
export async function keepFlight({ client, toasts }: KeepPorts): Promise<Recording | undefined> {
  const recording = await tryRequest(
    () => client.call('flightRecorderKeep', { clientId: client.id }),
    ({ message }) => toasts.show(`Nothing was kept. ${message}`),
  );
  if (recording) toasts.showBody(KeptToast, { recording });
  return recording;
}
