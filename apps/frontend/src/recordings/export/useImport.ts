import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';
import {
  nameOfFile,
  type ImportChoice,
  type ImportCommand,
  type ImportPlan,
  type ImportReport,
} from './import-messages.ts';

/** An import as the dialog shows it. */
export interface Import {
  /** Undefined until the file was looked at. */
  readonly plan: Readonly<ShallowRef<ImportPlan | undefined>>;
  readonly failure: Readonly<ShallowRef<string | undefined>>;
  /** 0 to 1 while it runs. */
  readonly share: Readonly<ShallowRef<number | undefined>>;
  preview(choice: ImportChoice): void;
  start(choice: ImportChoice, topics: readonly string[] | undefined): void;
  cancel(): void;
}

/** Makes a recording of a file in a worker. @param onDone gets the recording, and what was left out */
export function useImport(
  file: File,
  onDone: (recording: File, leftOut: readonly string[]) => void,
): Import {
  const plan = shallowRef<ImportPlan>();
  const failure = shallowRef<string>();
  const share = shallowRef<number>();
  let worker = openWorker();
  const send = (command: ImportCommand): void => worker.postMessage(command);

  function openWorker(): Worker {
    const opened = new Worker(new URL('./import-worker.ts', import.meta.url), { type: 'module' });
    opened.onmessage = ({ data }: MessageEvent<ImportReport>) => handle(data);
    opened.onerror = () =>
      handle({ kind: 'failed', message: 'This browser cannot read the file.' });
    return opened;
  }
  function handle(report: ImportReport): void {
    switch (report.kind) {
      case 'plan':
        plan.value = report.plan;
        return;
      case 'progress':
        share.value = report.share;
        return;
      case 'failed':
        [failure.value, share.value] = [report.message, undefined];
        return;
      case 'done': {
        const name = `${nameOfFile(file)}.mcap`;
        onDone(new File([report.file], name, { lastModified: Date.now() }), report.leftOut);
      }
    }
  }
  onScopeDispose(() => worker.terminate());
  return {
    ...{ plan, failure, share },
    preview(choice) {
      failure.value = undefined;
      send({ kind: 'preview', file, choice });
    },
    start(choice, topics) {
      [failure.value, share.value] = [undefined, 0];
      send({ kind: 'import', file, choice, topics });
    },
    cancel() {
      worker.terminate();
      [worker, share.value] = [openWorker(), undefined];
    },
  };
}
