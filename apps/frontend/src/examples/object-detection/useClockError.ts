import { shallowRef, watch, type Ref } from 'vue';
import { tryRequest } from '../../connection/useAttempt.ts';
import { useConnection } from '../../connection/useConnection.ts';
import type { ModulePlace } from '../../sessions/own/planned-session.ts';

/** Possible difference of the clocks of this page and the node that runs the modules. */
export function useClockError(place: Ref<ModulePlace>, isOn: Ref<boolean>) {
  const { client } = useConnection();
  /** Clock error that the node reports. [TS-10] */
  const nodeErrorMs = shallowRef(0);

  watch([place, isOn], async ([id, on]) => {
    nodeErrorMs.value = 0;
    if (!on || id === 'tab' || id === 'master') return;
    const report = await tryRequest(() => client.call('clientReport', { clientIds: [id] }));
    if (place.value === id) nodeErrorMs.value = report?.clients[0]?.clock?.errorMs ?? 0;
  });
  return {
    /** Milliseconds; `undefined` for a module in this tab, which uses the clock of this page. */
    errorMs(): number | undefined {
      const own = client.masterTime.estimate?.errorMs;
      return own === undefined || place.value === 'tab' ? undefined : own + nodeErrorMs.value;
    },
  };
}
