import { callWorker, type WorkerPeer } from '@ubii/worker-rpc/browser';
import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';
import { saveBlob, saveFile } from '../../files/save-file.ts';
import type { ReadableFile } from '../files/readable-file.ts';
import type { ExportPage, ExportRequest, ExportWorker } from './export-messages.ts';

/** An export as the dialog shows it. */
export interface Export {
  /** 0 to 1 while it runs. */
  readonly share: Readonly<ShallowRef<number | undefined>>;
  readonly failure: Readonly<ShallowRef<string | undefined>>;
  /** @returns what was left out, or undefined when nothing was saved */
  run(
    source: ReadableFile,
    request: ExportRequest,
    name: string,
  ): Promise<readonly string[] | undefined>;
  cancel(): void;
}

/** Not in the declarations of TypeScript yet. */
interface SavingWindow {
  showSaveFilePicker?(options: { readonly suggestedName: string }): Promise<FileSystemFileHandle>;
}

/** Whether a file is written while it is made. Other browsers keep it in memory until then. */
export const canStream = (): boolean =>
  (window as unknown as SavingWindow).showSaveFilePicker !== undefined;

/** Exports in a worker of its own, so that the recording can be played meanwhile. */
export function useExport(): Export {
  const share = shallowRef<number>();
  const failure = shallowRef<string>();
  let worker: WorkerPeer<ExportWorker> | undefined;
  let isCancelled = false;
  onScopeDispose(() => worker?.close());
  return {
    share,
    failure,
    async run(source, request, name) {
      [failure.value, isCancelled] = [undefined, false];
      const picked = await pickFile(name);
      if (picked === 'none') return undefined;
      share.value = 0;
      const opened = (worker = callWorker<ExportWorker, ExportPage>(
        new Worker(new URL('./export-worker.ts', import.meta.url), { type: 'module' }),
        { showProgress: (made) => void (share.value = made) },
        'This browser cannot export the recording.',
      ));
      try {
        const { file, leftOut, key } = await opened.calls.run(source, request, picked);
        if (file !== undefined) saveBlob(name, file);
        if (key !== undefined) saveFile({ name: `key-of-${name}.json`, text: key });
        return leftOut;
      } catch (error) {
        failure.value = isCancelled ? undefined : (error as Error).message;
        return undefined;
      } finally {
        opened.close();
        [worker, share.value] = [undefined, undefined];
      }
    },
    cancel() {
      isCancelled = true;
      worker?.calls.cancel().catch(() => undefined); // `run` says why.
    },
  };
}

/** Undefined where the browser downloads a whole file, `none` when the user chose none. */
async function pickFile(name: string): Promise<FileSystemFileHandle | undefined | 'none'> {
  try {
    return await (window as unknown as SavingWindow).showSaveFilePicker?.({ suggestedName: name });
  } catch (error) {
    if (error instanceof DOMException && error.name === 'AbortError') return 'none';
    return undefined;
  }
}
