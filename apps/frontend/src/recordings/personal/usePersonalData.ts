import type { Init, PersonalLabel } from '@ubii/proto';
import { shallowRef, watch, type ShallowRef } from 'vue';
import { useAttempt } from '../../connection/useAttempt.ts';
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
  const { problem, attempt } = useAttempt({ keepsProblem: true });

  async function take(
    call: () => Promise<{ readonly labels: readonly PersonalLabel[] }>,
  ): Promise<boolean> {
    const reply = await attempt(call);
    if (reply) labels.value = reply.labels;
    return reply !== undefined;
  }
  watch(isConnected, (connected) => connected && void take(() => client.call('personalDataGet')), {
    immediate: true,
  });
  return {
    labels,
    problem,
    save: (next) => take(() => client.call('personalDataSet', { labels: [...next] })),
  };
}
