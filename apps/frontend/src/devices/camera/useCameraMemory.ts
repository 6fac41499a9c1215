import { useLocalStorage } from '@vueuse/core';
import { reactive, watch } from 'vue';
import { NO_MEMORY, readMemory, remember, settingsOf, writeMemory } from './camera-memory.ts';
import type { PictureSettings } from './encode-picture.ts';

/** Settings of each camera of this browser, stored across visits. */
export function useCameraMemory() {
  const memory = useLocalStorage('ubii.camera', NO_MEMORY, {
    serializer: { read: readMemory, write: writeMemory },
    shallow: true,
    writeDefaults: false,
    // Tabs may use different settings.
    listenToStorageChanges: false,
  });
  const { chosen } = memory.value;
  const settings = reactive<PictureSettings>({ ...settingsOf(memory.value, chosen) });

  return {
    settings,
    /** Id of the camera used last; it may be unavailable now. */
    lastCamera: chosen,
    /**
     * Loads the settings of the chosen camera, and stores changes for it.
     * @param camera id of the chosen camera; empty: the browser's choice
     */
    follow(camera: () => string): void {
      watch(camera, (id) => {
        Object.assign(settings, memory.value.settings.get(id));
        memory.value = remember(memory.value, id, settings);
      });
      watch(settings, () => {
        memory.value = remember(memory.value, camera(), settings);
      });
    },
  };
}
