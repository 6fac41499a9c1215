export { createStage, type StageOptions } from './create-stage.ts';
export type { Scene, Stage } from './stage.ts';
