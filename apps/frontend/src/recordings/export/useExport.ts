import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';
import { saveBlob, saveFile } from '../../files/save-file.ts';
import type { ReadableFile } from '../files/readable-file.ts';
import type { ExportCommand, ExportReport, ExportRequest } from './export-messages.ts';

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
  let worker: Worker | undefined;
  const send = (command: ExportCommand): void => worker?.postMessage(command);

  function finished(name: string): Promise<readonly string[] | undefined> {
    return new Promise((resolve) => {
      const end = (leftOut: readonly string[] | undefined): void => {
        worker?.terminate();
        [worker, share.value] = [undefined, undefined];
        resolve(leftOut);
      };
      worker!.onmessage = ({ data }: MessageEvent<ExportReport>) => {
        if (data.kind === 'progress') share.value = data.share;
        else if (data.kind === 'failed') {
          failure.value = isCancelled ? undefined : data.message;
          end(undefined);
        } else {
          if (data.file !== undefined) saveBlob(name, data.file);
          if (data.key !== undefined) saveFile({ name: `key-of-${name}.json`, text: data.key });
          end(data.leftOut);
        }
      };
      worker!.onerror = () => {
        failure.value = 'This browser cannot export the recording.';
        end(undefined);
      };
    });
  }

  let isCancelled = false;
  onScopeDispose(() => worker?.terminate());
  return {
    ...{ share, failure },
    async run(source, request, name) {
      [failure.value, isCancelled] = [undefined, false];
      const picked = await pickFile(name);
      if (picked === 'none') return undefined;
      share.value = 0;
      worker = new Worker(new URL('./export-worker.ts', import.meta.url), { type: 'module' });
      const end = finished(name);
      send({ kind: 'export', source, request, handle: picked });
      return end;
    },
    cancel() {
      isCancelled = true;
      send({ kind: 'cancel' });
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
