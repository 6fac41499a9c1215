import type { OptionName } from './config.ts';

/** `dataDir` -> `--data-dir` */
export function flagName(name: OptionName): string {
  return `--${name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`)}`;
}

/** `dataDir` -> `UBII_DATA_DIR` */
export function environmentName(name: OptionName): string {
  return `UBII_${name.replace(/[A-Z]/g, (letter) => `_${letter}`).toUpperCase()}`;
}
