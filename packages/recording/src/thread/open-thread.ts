import { Worker } from 'node:worker_threads';

/** A thread to open, and what follows from what it says. */
export interface ThreadOptions<Message> {
  readonly workerFile: URL;
  readonly name: string;
  readonly workerData: unknown;
  readonly heapMib: number;
  onMessage(message: Message): void;
  /** @param reason part of a sentence */
  onEnd(reason: string): void;
}

/** Opens a thread that keeps no process alive, without the environment and arguments of the program. */
export function openThread<Message>(options: ThreadOptions<Message>): Worker {
  const { workerFile, name, workerData, heapMib: maxOldGenerationSizeMb } = options;
  const worker = new Worker(workerFile, {
    ...{ name, workerData, env: {}, argv: [], execArgv: [] },
    resourceLimits: { maxOldGenerationSizeMb },
  });
  worker.on('message', (message: Message) => options.onMessage(message));
  worker.on('error', (error) => options.onEnd(error.message));
  worker.on('exit', () => options.onEnd('its thread ended'));
  worker.unref();
  return worker;
}
