import type { UbiiClient } from '@ubii/client-web';
import type { Toasts } from '../ui/toasts/toasts.ts';

/** Says once that the page went on at another master of the cluster. [CU-92] */
export function tellMoves(
  client: Pick<UbiiClient, 'onMaster'>,
  toasts: Pick<Toasts, 'show'>,
): void {
  client.onMaster(({ url }) => {
    toasts.show(`The master was lost. Moved to ${new URL(url).host}.`, undefined, 'master');
  });
}
