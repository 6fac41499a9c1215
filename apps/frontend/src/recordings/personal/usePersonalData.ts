import { ConnectionError } from '@ubii/client-web';
import { ServiceError, type Init, type PersonalLabel } from '@ubii/proto';
import { shallowRef, watch, type ShallowRef } from 'vue';
import { useConnection } from '../../connection/useConnection.ts';

/** Labels of personal data at the master. */
export interface PersonalLabels {
  /** Undefined until they are known. */
  readonly labels: Readonly<ShallowRef<readonly PersonalLabel[] | undefined>>;
  /** Why the last request failed, one sentence. */
  readonly problem: Readonly<ShallowRef<string | undefined>>;
  /** @returns whether the master keeps them now */
  save(labels: readonly Init<PersonalLabel>[]): Promise<boolean>;
}

export function usePersonalData(): PersonalLabels {
  const { client, isConnected } = useConnection();
  const labels = shallowRef<readonly PersonalLabel[]>();
  const problem = shallowRef<string>();

  async function attempt(
    call: () => Promise<{ readonly labels: readonly PersonalLabel[] }>,
  ): Promise<boolean> {
    try {
      labels.value = (await call()).labels;
      problem.value = undefined;
      return true;
    } catch (cause) {
      if (!(cause instanceof ServiceError || cause instanceof ConnectionError)) throw cause;
      problem.value = cause.message;
      return false;
    }
  }
  watch(
    isConnected,
    (connected) => connected && void attempt(() => client.call('personalDataGet')),
    { immediate: true },
  );
  return {
    ...{ labels, problem },
    save: (next) => attempt(() => client.call('personalDataSet', { labels: [...next] })),
  };
}
