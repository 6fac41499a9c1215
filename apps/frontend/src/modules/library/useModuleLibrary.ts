import { ServiceError, type ProcessingModule } from '@ubii/proto';
import { computed, shallowRef, type ComputedRef, type ShallowRef } from 'vue';
import { usePoll } from '../../connection/poll.ts';
import { tryRequest } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import { moduleEntries, type ModuleEntry } from './module-entry.ts';

/** Interval of requests, milliseconds: changes of files and nodes are not announced completely. [SE-23] */
const INTERVAL_MS = 3000;

/** All modules of the master and the nodes, updated while the calling scope is active. */
export interface ModuleLibrary {
  /** `undefined` until the first list arrives. */
  readonly entries: ComputedRef<readonly ModuleEntry[] | undefined>;
  readonly error: Readonly<ShallowRef<ServiceError | undefined>>;
  refresh(): Promise<void>;
}

export function useModuleLibrary(): ModuleLibrary {
  const { client, isConnected, nodes, sessions } = useConnection();
  nodes.watch(INTERVAL_MS);
  const modules = shallowRef<readonly ProcessingModule[]>();
  const error = shallowRef<ServiceError>();

  async function refresh(): Promise<void> {
    const reply = await tryRequest(
      () => client.call('processingModuleDatabaseGetList'),
      (cause) => {
        if (cause instanceof ServiceError) error.value = cause;
      },
    );
    if (reply === undefined) return;
    modules.value = reply.elements;
    error.value = undefined;
  }
  usePoll(refresh, INTERVAL_MS, isConnected);

  return {
    entries: computed(
      () =>
        modules.value &&
        moduleEntries(modules.value, nodes.list.value ?? [], sessions.list.value ?? []),
    ),
    error,
    refresh,
  };
}
