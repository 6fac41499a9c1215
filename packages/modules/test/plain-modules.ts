import { MODULES } from '../src/index.ts';

/** Modules without asset sets, which run in every kind of sandbox. */
export const PLAIN_MODULES = MODULES.filter(({ assets = [] }) => assets.length === 0);
