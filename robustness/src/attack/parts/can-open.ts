import type { Outsider } from '@ubii/harness';

const TIMEOUT_MS = 5_000;

/** Whether somebody is answered by the master within 5 s. */
export async function canOpen(caller: Outsider): Promise<boolean> {
  const late = new Promise<boolean>((resolve) => {
    setTimeout(() => resolve(false), TIMEOUT_MS).unref();
  });
  const answered = caller.ask('GET', '/health').then(({ status }) => status === 200);
  return Promise.race([answered, late]);
}
