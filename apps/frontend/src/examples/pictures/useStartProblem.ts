import { useConnection } from '../../connection/useConnection.ts';
import { useRole } from '../../connection/useRole.ts';
import { computed, type ComputedRef } from 'vue';
import type { PictureSources } from './usePictureSource.ts';

/** Returns why a session with these pictures cannot be started now, one sentence; `undefined` when it can. */
export function useStartProblem(sources: PictureSources): ComputedRef<string | undefined> {
  const { isConnected } = useConnection();
  const { role } = useRole();
  const { kind, topic, element } = sources;
  return computed(() => {
    if (role.value === 'player' || role.value === 'viewer') {
      return `A ${role.value} cannot start sessions.`;
    }
    if (!isConnected.value) return 'This page is not connected to the master.';
    if (kind.value === 'topic' && topic.value === '') return 'Choose a topic first.';
    if (kind.value === 'photo' && !element.value) return 'Choose an image first.';
    return undefined;
  });
}
