import { ProcessingModuleLanguage, type ProcessingModule } from '@ubii/proto';

/** The definition of a module that completes a request. */
export interface ModuleOffer {
  readonly module: ProcessingModule;
  /** It came with the program or from the operator's folder [PM-51]. */
  readonly isTrusted: boolean;
}

/** No language: written as "not given" [SE-2]. */
export const NO_LANGUAGE = ProcessingModuleLanguage.CPP;
