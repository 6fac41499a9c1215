import { ConfigError } from '@ubii/program';
import { findMasters, ownAddresses } from '@ubii/discovery';
import type { FindOptions, FoundMaster } from '@ubii/discovery';
import type { Log } from './log.ts';

/** Time for further masters to answer after the first one, milliseconds. */
const OTHERS_MS = 1_500;
/** Time without an answer after which a message is logged, milliseconds. */
const NOTICE_DELAY_MS = 3_000;

/**
 * Searches the local network for a master until one answers. [DI-5]
 * @returns the address of the master
 * @throws ConfigError with a list of the masters when several answer
 */
export async function discoverMaster(
  log: Log,
  where: Pick<FindOptions, 'addresses' | 'port'> = { addresses: ownAddresses },
): Promise<string> {
  let found: readonly FoundMaster[] = [];
  const timers: NodeJS.Timeout[] = [];
  let end: () => Promise<void> = async () => undefined;
  await new Promise<void>((resolve) => {
    const notice = setTimeout(() => {
      log('info', 'No master found in the local network yet. Searching');
    }, NOTICE_DELAY_MS);
    timers.push(notice);
    end = findMasters({
      ...where,
      onProblem: (reason) => log('warn', `Search for a master: ${reason}`),
      onFound: (masters) => {
        found = masters;
        if (masters.length > 1) return;
        clearTimeout(notice);
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
      `Found ${found.length} masters in the local network. Choose one with --master:`,
      ...found.map((master) => `  --master ${master.url}   ${describeMaster(master)}`),
    ].join('\n'),
  );
}

function describeMaster({ name, version, url }: FoundMaster): string {
  return `"${name}" (${version}) at ${url}`;
}
