import { callWorker, type WorkerPeer } from '@ubii/worker-rpc/browser';
import { onScopeDispose, shallowRef, type ShallowRef } from 'vue';
import {
  nameOfFile,
  type ImportChoice,
  type ImportPage,
  type ImportPlan,
  type ImportWorker,
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

  function openWorker(): WorkerPeer<ImportWorker> {
    return callWorker<ImportWorker, ImportPage>(
      new Worker(new URL('./import-worker.ts', import.meta.url), { type: 'module' }),
      { showProgress: (made) => void (share.value = made) },
      'This browser cannot read the file.',
    );
  }
  const fail = ({ message }: Error): void => {
    [failure.value, share.value] = [message, undefined];
  };
  onScopeDispose(() => worker.close());
  return {
    plan,
    failure,
    share,
    preview(choice) {
      failure.value = undefined;
      worker.calls.plan(file, choice).then((made) => void (plan.value = made), fail);
    },
    start(choice, topics) {
      [failure.value, share.value] = [undefined, 0];
      worker.calls.run(file, choice, topics).then(({ recording, leftOut }) => {
        const name = `${nameOfFile(file)}.mcap`;
        onDone(new File([recording], name, { lastModified: Date.now() }), leftOut);
      }, fail);
    },
    cancel() {
      worker.close();
      [worker, share.value] = [openWorker(), undefined];
    },
  };
}
