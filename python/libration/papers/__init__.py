from .erratum import Erratum, Kind, errata
from .exact import juchem_neto, salas_22, salas_23, salas_24
from .limit import Limit, limits
from .picture import Picture
