import { watch } from 'vue';
import { useRoute } from 'vue-router';
import type { Shell } from '../page/shell.ts';
import { thingAt, useRecent } from '../page/recent.ts';

/** Notes each session, module, recording, example and set of panels whose page is opened. */
export function useNoteOpened({ pageTitle }: Pick<Shell, 'pageTitle'>): void {
  const route = useRoute();
  const { note } = useRecent();
  watch(
    () => [route.path, pageTitle.value ?? route.meta.title ?? ''] as const,
    ([path, title]) => {
      const id = thingAt(path);
      if (id !== undefined) note({ id, title, path });
    },
    { immediate: true, flush: 'post' },
  );
}
