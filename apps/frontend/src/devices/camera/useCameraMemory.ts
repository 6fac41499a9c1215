import { useLocalStorage } from '@vueuse/core';
import { reactive, watch } from 'vue';
import { NO_MEMORY, readMemory, remember, settingsOf, writeMemory } from './camera-memory.ts';
import type { PictureSettings } from './encode-picture.ts';

/** How pictures are sent, remembered for each camera of this browser. */
export function useCameraMemory() {
  const memory = useLocalStorage('ubii.camera', NO_MEMORY, {
    serializer: { read: readMemory, write: writeMemory },
    shallow: true,
    writeDefaults: false,
    // Another tab may send another way.
    listenToStorageChanges: false,
  });
  const { chosen } = memory.value;
  const settings = reactive<PictureSettings>({ ...settingsOf(memory.value, chosen) });

  return {
    settings,
    /** Id of the camera that was used last; it may be gone by now. */
    lastCamera: chosen,
    /**
     * Another camera brings its own settings, when it has any; what is changed is kept for it.
     * @param camera id of the one that is chosen; empty while it is the browser's choice
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
