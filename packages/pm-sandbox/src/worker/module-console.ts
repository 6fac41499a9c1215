import { CONSOLE_LEVELS, formatLog, SILENT_CONSOLE_METHODS } from './format-log.ts';

/** The console of one instance: each line goes to `onLog`. [PM-14] */
export function createModuleConsole(
  onLog: (level: string, text: string) => void,
): Readonly<Record<string, (...values: unknown[]) => void>> {
  return Object.freeze(
    Object.fromEntries([
      ...SILENT_CONSOLE_METHODS.map((method) => [method, () => undefined] as const),
      ...Object.entries(CONSOLE_LEVELS).map(
        ([method, level]) =>
          [method, (...values: unknown[]) => onLog(level, formatLog(values))] as const,
      ),
    ]),
  );
}
