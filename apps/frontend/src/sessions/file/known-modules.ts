import type { UbiiClient } from '@ubii/client-web';
import type { ProcessingModule } from '@ubii/proto';
import { tryRequest } from '../../connection/useAttempt.ts';

/** Returns all modules of the master and the nodes; `undefined` when the master does not reply. */
export async function knownModules(
  client: Pick<UbiiClient, 'call'>,
): Promise<readonly ProcessingModule[] | undefined> {
  return (await tryRequest(() => client.call('processingModuleDatabaseGetList')))?.elements;
}
