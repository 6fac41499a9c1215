import type { UbiiClient } from '@ubii/client-web/node';
import { INFO_TOPICS } from '@ubii/proto';
import type { Device } from '@ubii/proto';

/** Calls `fn` with all devices of the master, now and whenever one comes, changes or goes. @returns ends it */
export function watchDevices(
  client: UbiiClient,
  fn: (devices: readonly Device[]) => void,
  onError: (error: unknown) => void,
): () => void {
  const devices = new Map<string, Device>();
  let isEnded = false;
  const tell = (): void => {
    if (!isEnded) fn([...devices.values()]);
  };
  const added = client.subscribe({ topic: INFO_TOPICS.newDevice }, { format: 'device' });
  added.onRecord(({ value }) => {
    devices.set(value.id, value);
    tell();
  });
  const removed = client.subscribe({ topic: INFO_TOPICS.deleteDevice }, { format: 'device' });
  removed.onRecord(({ value }) => {
    if (devices.delete(value.id)) tell();
  });
  /** What came and went while there was no connection was not announced to us. */
  const refresh = async (): Promise<void> => {
    await Promise.all([added.ready, removed.ready]);
    const { elements } = await client.call('deviceGetList');
    devices.clear();
    for (const device of elements) devices.set(device.id, device);
    tell();
  };
  const stop = client.onState(({ status }) => {
    if (status === 'connected') refresh().catch(onError);
  });
  if (client.state.status === 'connected') refresh().catch(onError);
  return () => {
    isEnded = true;
    stop();
    for (const subscription of [added, removed]) subscription.close().catch(() => undefined);
  };
}
