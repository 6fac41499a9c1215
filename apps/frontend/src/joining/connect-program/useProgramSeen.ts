import { ClientState, type Client } from '@ubii/proto';
import { computed, type ComputedRef, type Ref } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';
import type { ProgramKind } from './program-kinds.ts';

/** What the master sees of a program. */
export interface ProgramSeen {
  /** Its client while it is connected. */
  readonly client: ComputedRef<Client | undefined>;
  /** Modules that it offers. */
  readonly modules: ComputedRef<Client['processingModules']>;
}

/** Follows the program of a kind. */
export function useProgramSeen(kind: Readonly<Ref<ProgramKind>>): ProgramSeen {
  const { clients } = useConnection();
  const client = computed(() =>
    clients.list.value?.findLast(
      ({ name, state }) => name === kind.value.clientName && state === ClientState.ACTIVE,
    ),
  );
  return {
    client,
    modules: computed(() => client.value?.processingModules ?? []),
  };
}
