import type { CsvPlan, XdfPlan } from '@ubii/recording/import';

/** How people want a table to be read. */
export interface ImportChoice {
  /** Empty: found by its name. */
  readonly timeColumn: string;
  readonly timeUnit: 'auto' | 's' | 'ms' | 'us' | 'ns' | 'iso';
  readonly layout: 'topics' | 'object';
}

/** What would be imported. */
export type ImportPlan =
  | ({ readonly kind: 'csv' } & CsvPlan)
  | ({ readonly kind: 'xdf' } & Pick<XdfPlan, 'damage'> & {
        readonly topics: readonly {
          readonly topic: string;
          /** Undefined when the texts become markers. */
          readonly format: string | undefined;
          readonly channels: number;
        }[];
      });

/** What the page calls of the worker that imports. */
export interface ImportWorker {
  plan(file: File, choice: ImportChoice): Promise<ImportPlan>;
  run(
    file: File,
    choice: ImportChoice,
    topics: readonly string[] | undefined,
  ): Promise<{ readonly recording: Blob; readonly leftOut: readonly string[] }>;
}

/** What the worker calls of the page. */
export interface ImportPage {
  /** @param share 0 to 1 */
  showProgress(share: number): void;
}

/** Name of a recording that is made of a file. */
export const nameOfFile = (file: { readonly name: string }): string =>
  file.name.replace(/\.\w+$/, '');
