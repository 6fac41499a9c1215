import { ConnectionError, type UbiiClient } from '@ubii/client-web';
import { ServiceError, type ProcessingModule } from '@ubii/proto';

/** Every module somebody here has; `undefined` when the master does not answer now. */
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
