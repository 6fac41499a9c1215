import { createClient } from '@ubii/client-web';

/**
 * Runs the first program in the page, as a separate client.
 * @returns a function that ends it
 */
export async function runFirstProgram(log: (line: string) => void): Promise<() => Promise<void>> {
  const client = createClient({ name: 'first program' });
  await client.connect();
  log(`connected as ${client.name}`);

  let seen = 0;
  client.subscribe('/first-program/lamp', { format: 'bool' }).onRecord(({ value }) => {
    seen += 1;
    log(`the lamp is ${value ? 'on' : 'off'}`);
    client.publish('/first-program/seen', 'int32', seen);
  });

  let step = 0;
  const timer = setInterval(() => {
    step += 1;
    client.publish('/first-program/wave', 'double', Math.sin(step / 10));
  }, 50);

  return async () => {
    clearInterval(timer);
    await client.close(); // Deregisters the client.
    log('closed');
  };
}
