import { findMasters, ownAddresses } from '@ubii/discovery';
import type { FindOptions, FoundMaster } from '@ubii/discovery';
import type { Log } from './log.ts';
import { ConfigError } from './read-config.ts';

/** Others have so long to answer after the first one, milliseconds. */
const OTHERS_MS = 1_500;
/** Who waits wants to know what for, milliseconds. */
const PATIENCE_MS = 3_000;

/**
 * Looks for the one master of the local network, for as long as it takes. [DI-5]
 * @returns its address
 * @throws ConfigError that lists them when there are several
 */
export async function discoverMaster(
  log: Log,
  where: Pick<FindOptions, 'addresses' | 'port'> = { addresses: ownAddresses },
): Promise<string> {
  let found: readonly FoundMaster[] = [];
  const timers: NodeJS.Timeout[] = [];
  let end: () => Promise<void> = async () => undefined;
  await new Promise<void>((resolve) => {
    const patience = setTimeout(() => {
      log('info', 'No master found in the local network yet. Still looking for one');
    }, PATIENCE_MS);
    timers.push(patience);
    end = findMasters({
      ...where,
      onProblem: (reason) => log('warn', `Looking for a master: ${reason}`),
      onFound: (masters) => {
        found = masters;
        if (masters.length > 1) return;
        clearTimeout(patience);
        timers.push(setTimeout(resolve, OTHERS_MS));
      },
    });
  });
  for (const timer of timers) clearTimeout(timer);
  await end();
  const [only] = found;
  if (only !== undefined && found.length === 1) {
    log('info', `Found ${describeMaster(only)}`);
    return only.url;
  }
  throw new ConfigError(
    [
      `Found ${found.length} masters in the local network. Choose one with --master.`,
      ...found.map((master) => `  --master ${master.url}   ${describeMaster(master)}`),
    ].join('\n'),
  );
}

function describeMaster({ name, version, url }: FoundMaster): string {
  return `"${name}" (${version}) at ${url}`;
}
