import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import { ServiceError, type ProcessingModule } from '@ubii/proto';

/** Returns all modules of the master and the nodes; `undefined` when the master does not reply. */
export async function knownModules(
  client: Pick<UbiiClient, 'call'>,
): Promise<readonly ProcessingModule[] | undefined> {
  try {
    return (await client.call('processingModuleDatabaseGetList')).elements;
  } catch (cause) {
    if (!(cause instanceof ConnectionError || cause instanceof ServiceError)) throw cause;
    return undefined;
  }
}
