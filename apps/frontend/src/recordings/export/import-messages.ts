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

/** What the page asks of the worker that imports. */
export type ImportCommand =
  | { readonly kind: 'preview'; readonly file: File; readonly choice: ImportChoice }
  | {
      readonly kind: 'import';
      readonly file: File;
      readonly choice: ImportChoice;
      readonly topics: readonly string[] | undefined;
    }
  | { readonly kind: 'cancel' };

/** What the worker says. */
export type ImportReport =
  | { readonly kind: 'plan'; readonly plan: ImportPlan }
  | { readonly kind: 'progress'; readonly share: number }
  | { readonly kind: 'done'; readonly file: Blob; readonly leftOut: readonly string[] }
  | { readonly kind: 'failed'; readonly message: string };

/** Name of a recording that is made of a file. */
export const nameOfFile = (file: { readonly name: string }): string =>
  file.name.replace(/\.\w+$/, '');
